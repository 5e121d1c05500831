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

std::vector<FemBall> sound_balls_near(const FemBall& ball, double contact_time) {
  constexpr double half = 0.5, most_slow = 0.6, most_of_deviator = 1.5;
  std::vector<FemBall> near(2, ball);
  if (ball.branches.size() > 1)
    near[0].branches[1].ratio += half * most_slow;
  else
    near[0].branches.push_back({.ratio = half * most_slow, .time = second_time * contact_time});
  const FemBranch& first = ball.branches.front();
  near[1].branches.push_back({.ratio = half * most_of_deviator,
                              .time = first.time,
                              .deviator_alone = !first.deviator_alone});
  for (const FemBall& other : fem_materials()) {
    if (std::any_of(near.begin(), near.end(),
                    [&](const FemBall& known) { return known.elastic == other.elastic; }))
      continue;
    near.push_back(ball);
    near.back().elastic = other.elastic;
    near.back().second_share = other.second_share;
    near.back().terms = other.terms;
  }
  return near;
}

}  // namespace trials
