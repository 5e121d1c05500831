#include "comparisons/discrepancy/diagnosis/asked_fem/mesh_errors.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"
#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

void compare_ball(std::size_t ball, const std::vector<Impact>& impacts, const FittedFem& fitted,
                  const TwoMeshes& meshes, double missing, MeshErrors& errors) {
  std::vector<ModelledImpact> before(impacts.size()), after(impacts.size());
  in_parallel(impacts.size(), [&](std::size_t i) {
    before[i] = meshes.coarse.run(ball, impacts[i], fitted.material, fitted.effects);
    after[i] = meshes.fine.run(ball, impacts[i], fitted.material, fitted.effects);
  });
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    errors.of_history =
        std::max(errors.of_history, missing * history_difference(before[i], after[i]));
    const ScalarShares added = shares_added(before[i].scalars, after[i].scalars);
    for (std::size_t k = 0; k < added.size(); ++k)
      errors.of_scalars[k] = std::max(errors.of_scalars[k], missing * std::abs(added[k]));
    errors.known.push_back({.ball = ball,
                            .speed = impacts[i].speed,
                            .finer = difference_between(before[i], after[i]),
                            .faster = {},
                            .reach = 0.0});
  }
}

}  // namespace

ScalarShares shares_added(const ImpactScalars& first, const ImpactScalars& second) {
  ScalarShares shares;
  for (std::size_t k = 0; k < shares.size(); ++k)
    shares[k] = second.*scalar_quantities[k].modelled / first.*scalar_quantities[k].modelled - 1.0;
  return shares;
}

double share_missing_beyond(int halvings) {
  constexpr double order = 1.5;
  return 1.0 / (std::exp2(order * halvings) - 1.0);
}

double share_missing_in_a_search(int halvings) {
  constexpr double of_other_balls = 0.4;
  return std::max(share_missing_beyond(halvings), of_other_balls);
}

MeshErrors compare_meshes(const Observations& all, const std::vector<FittedFem>& balls,
                          const TwoMeshes& meshes, double missing) {
  MeshErrors errors;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball)
    if (is_hit(all, ball))
      compare_ball(ball, impacts_of(all, ball), balls[ball], meshes, missing, errors);
  return errors;
}

Observations with_errors_of_mesh(Observations seen, double of_history,
                                 const ScalarShares& of_scalars) {
  for (MeasuredImpact& shot : seen.shots) {
    for (std::size_t k = 0; k < scalar_quantities.size(); ++k)
      if (Measured& one = shot.*scalar_quantities[k].measured; one.has_error())
        one.uncertainty = std::hypot(*one.uncertainty, of_scalars[k] * *one.value);
    if (!shot.has_history()) continue;
    const std::vector<double>& force = shot.trace.force;
    add_numerical_error(shot, of_history * *std::max_element(force.begin(), force.end()));
  }
  return seen;
}

}  // namespace rebound
