#include "comparisons/discrepancy/diagnosis/asked_fem/settled_balls.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"

namespace rebound {
namespace {

std::vector<Material> materials_of(const std::vector<FittedFem>& balls) {
  std::vector<Material> materials;
  materials.reserve(balls.size());
  for (const FittedFem& ball : balls) materials.push_back(ball.material);
  return materials;
}

/// Cells of the search, and those that correct it.
TwoMeshes two_meshes(const FemProblem& problem, const Observations& all,
                     const std::vector<Material>& materials, const RunControl& control) {
  const int halvings = halvings_to_finer(problem, all);
  return {.coarse = FemBelief(problem, all, materials, search_cells, control),
          .fine = FemBelief(problem, all, materials, search_cells, control, halvings),
          .halvings = halvings};
}

/// Is it made of the same kind of material, and on the same kind of plate?
bool is_of_one_kind(const FittedFem& a, const FittedFem& b) {
  const auto &first = a.material.branches, &second = b.material.branches;
  return a.effects.size() == b.effects.size() &&
         std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& x, const auto& y) { return x.relaxes == y.relaxes; });
}

bool all_are_done(const std::vector<FittedFem>& balls, const std::vector<bool>& is_behind) {
  for (std::size_t k = 0; k < balls.size(); ++k)
    if (balls[k].samples > 0 && !balls[k].follows() && !balls[k].is_far() && !is_behind[k])
      return false;
  return true;
}

}  // namespace

SettledBalls settle_balls(const Observations& all, const Observations& seen,
                          const LumpedAnswer& lumped, const FemProblem& problem,
                          const RunControl& control) {
  const auto rough = fit_rough_balls(all, seen, lumped.law, problem, control);
  const auto meshes =
      std::make_shared<const TwoMeshes>(two_meshes(problem, all, materials_of(rough), control));
  SettledBalls settled{.balls = rough,
                       .errors = {},
                       .cells = {meshes->coarse.cells(), meshes->fine.cells()},
                       .meshes = meshes,
                       .fem = nullptr};
  std::vector<bool> is_behind(all.balls.size(), false);
  const auto fit_all = [&](const auto& fitted_ball) {
    settled.errors =
        compare_meshes(all, settled.balls, *meshes, share_missing_in_a_search(meshes->halvings));
    settled.fem = std::make_shared<const FemBelief>(meshes->coarse.with(settled.errors.known));
    const Observations with_errors =
        with_errors_of_mesh(seen, settled.errors.of_history, settled.errors.of_scalars);
    for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
      if (!is_hit(all, ball) || is_behind[ball]) continue;
      const OwnBallFit own(with_errors, shots_for_fem(seen, all, ball), lumped, *settled.fem,
                           control);
      settled.balls[ball] = fitted_ball(own, settled.balls[ball]);
      is_behind[ball] = own.is_behind(settled.balls[ball]);
    }
  };
  fit_all([&](const OwnBallFit& own, const FittedFem& near) {
    FittedFem plain = own.again(near);
    if (own.is_behind(plain)) return plain;
    const FittedFem rigid = own.of_best_kind(plain);
    return rigid.follows() ? rigid : own.on_best_plate(plain, rigid, lumped.plates);
  });
  // What the finer mesh adds is known for the ball that it was run with.
  constexpr int most_rounds = 3;
  bool is_another = !std::equal(rough.begin(), rough.end(), settled.balls.begin(), is_of_one_kind);
  for (int round = 0;
       round < most_rounds && (is_another || !all_are_done(settled.balls, is_behind)); ++round) {
    fit_all([](const OwnBallFit& own, const FittedFem& near) { return own.again(near); });
    is_another = false;
  }
  return settled;
}

}  // namespace rebound
