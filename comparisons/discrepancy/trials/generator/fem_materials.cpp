#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"

#include <algorithm>

namespace trials {
namespace {

constexpr double second_time = 0.08;  // over that of the contact

}  // namespace

/// Ratios are the largest that are drawn, times come with the trial.
const std::vector<FemBall>& fem_materials() {
  static const std::vector<FemBall> all = {
      {.material = "neo-Hookean; nu 0.3; one branch",
       .poisson_ratio = 0.3,
       .branches = {{.ratio = 2.0}}},
      {.material = "neo-Hookean; nu 0.45; one branch",
       .poisson_ratio = 0.45,
       .branches = {{.ratio = 2.0}}},
      {.material = "neo-Hookean; nu 0.4; two branches",
       .poisson_ratio = 0.4,
       .branches = {{.ratio = 0.6}, {.ratio = 0.6}}},
      {.material = "neo-Hookean; nu 0.35; hardly any loss",
       .poisson_ratio = 0.35,
       .branches = {{.ratio = 0.1}}},
      {.material = "neo-Hookean; nu 0.4; branch of the deviator",
       .poisson_ratio = 0.4,
       .branches = {{.ratio = 1.5, .deviator_alone = true}}},
      {.material = "Mooney-Rivlin; nu 0.45; one branch",
       .elastic = "mooney-rivlin",
       .poisson_ratio = 0.45,
       .second_share = 0.3,
       .branches = {{.ratio = 2.0}}},
      {.material = "hyperfoam of exponent 4; nu 0.3; one branch",
       .elastic = "hyperfoam",
       .poisson_ratio = 0.3,
       .terms = {{1.0, 4.0}},
       .branches = {{.ratio = 2.0}}},
      {.material = "Ogden of exponent 3; nu 0.42; one branch",
       .elastic = "ogden",
       .poisson_ratio = 0.42,
       .terms = {{1.0, 3.0}},
       .branches = {{.ratio = 2.0}}}};
  return all;
}

FemBall draw_material(double modulus, double contact_time, const FemBall& kind, Random& random) {
  FemBall ball = kind;
  ball.modulus = modulus;
  for (std::size_t k = 0; k < ball.branches.size(); ++k) {
    ball.branches[k].ratio *= random.uniform(0.25, 1.0);
    ball.branches[k].time = contact_time * (k == 0 ? random.uniform(0.01, 0.03) : second_time);
  }
  return ball;
}

FemBall with_more_branches(FemBall ball, double contact_time, const MoreBranches& more) {
  constexpr double half = 0.5, most_slow = 0.6, most_of_deviator = 1.5;
  const FemBranch first = ball.branches.front();
  const auto add = [&](FemBranch branch, double ratio) {
    branch.ratio = std::max(0.0, branch.ratio + ratio);
    if (branch.ratio > 0.0) ball.branches.push_back(branch);
  };
  FemBranch slow{.ratio = 0.0, .time = second_time * contact_time};
  if (ball.branches.size() > 1) {
    slow = ball.branches.back();
    ball.branches.pop_back();
  }
  add(slow, more.slow * half * most_slow);
  add({.ratio = 0.0, .time = first.time, .deviator_alone = !first.deviator_alone},
      more.of_other_kind * half * most_of_deviator);
  return ball;
}

std::vector<FemBall> other_laws_of(const FemBall& ball) {
  std::vector<FemBall> others;
  for (const FemBall& kind : fem_materials()) {
    const auto is_known = [&](const FemBall& known) { return known.elastic == kind.elastic; };
    if (is_known(ball) || std::any_of(others.begin(), others.end(), is_known)) continue;
    others.push_back(ball);
    others.back().elastic = kind.elastic;
    others.back().second_share = kind.second_share;
    others.back().terms = kind.terms;
  }
  return others;
}

}  // namespace trials
