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

/// Is it made of the same kind of material, and on the same kind of plate?
bool is_of_one_kind(const FittedFem& a, const FittedFem& b) {
  const auto &first = a.material.branches, &second = b.material.branches;
  return a.effects.size() == b.effects.size() &&
         std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& x, const auto& y) { return x.relaxes == y.relaxes; });
}

}  // namespace

SettledBalls settle_balls(const Observations& all, const Observations& seen,
                          const HypothesisFit& lumped, const FemProblem& problem,
                          const std::vector<EffectChoice>& plates, const RunControl& control) {
  const auto rough = fit_rough_balls(all, seen, lumped, problem, control);
  constexpr int one_halving = 1;
  const FemBelief coarse(problem, all, materials_of(rough), search_cells, control);
  const FemBelief fine(problem, all, materials_of(rough), search_cells, control, one_halving);
  SettledBalls settled{
      .balls = rough, .errors = {}, .cells = {coarse.cells(), fine.cells()}, .fem = nullptr};
  const auto fit_all = [&](const auto& fitted_ball) {
    settled.errors = compare_meshes(all, settled.balls, coarse, fine);
    settled.fem = std::make_shared<const FemBelief>(coarse.with(settled.errors.known));
    const Observations with_errors =
        with_errors_of_mesh(seen, settled.errors.of_history, settled.errors.of_scalars);
    for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
      if (!is_hit(all, ball)) continue;
      const OwnBallFit own(with_errors, shots_for_fem(seen, all, ball), lumped, *settled.fem,
                           control);
      settled.balls[ball] = fitted_ball(own, settled.balls[ball]);
    }
  };
  fit_all([&](const OwnBallFit& own, const FittedFem& near) {
    const FittedFem plain = own.again(near), rigid = own.of_best_kind(plain);
    return rigid.follows() ? rigid : own.on_best_plate(plain, rigid, plates);
  });
  if (!std::equal(rough.begin(), rough.end(), settled.balls.begin(), is_of_one_kind))
    fit_all([](const OwnBallFit& own, const FittedFem& near) { return own.again(near); });
  return settled;
}

}  // namespace rebound
