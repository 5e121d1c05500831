#include "fem/interface/adhesive_range.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "fem/interface/engineering_moduli.hpp"

namespace rebound::fem {
namespace {

constexpr double shortest_range = 0.01;  ///< over R, where the range is chosen
constexpr double longest_range = 0.1;
constexpr double range_allowed = 0.25;
constexpr double traction_allowed = 0.1;  ///< over E

}  // namespace

double adhesive_range(const FemProblem& problem, const Moduli& instantaneous) {
  if (problem.adhesion.range > 0.0) return problem.adhesion.range;
  const double radius = problem.sphere.radius(), work = problem.adhesion.work;
  const double plane_strain = plane_strain_modulus(instantaneous);
  const double gentle = 10.0 * std::cbrt(radius * work * work / (plane_strain * plane_strain));
  return std::clamp(gentle, shortest_range * radius, longest_range * radius);
}

AdhesiveTraction chosen_adhesion(const FemProblem& problem, const Moduli& instantaneous) {
  return {.work = problem.adhesion.work, .range = adhesive_range(problem, instantaneous)};
}

void check_adhesion(const FemProblem& problem, const Moduli& instantaneous) {
  const AdhesiveTraction& adhesion = problem.adhesion;
  const double radius = problem.sphere.radius();
  require_limits(adhesion, {"model.adhesion"});
  if (adhesion.range > range_allowed * radius)
    refuse_value("model.adhesion.range", adhesion.range, "0 m, or up to a quarter of the radius");
  if (!adhesion.acts()) return;
  const double range = adhesive_range(problem, instantaneous);
  const double most = 0.5 * traction_allowed * youngs_modulus(instantaneous) * range;
  if (adhesion.work > most)
    refuse_value("model.adhesion.work", adhesion.work,
                 "up to " + std::to_string(static_cast<long>(most)) +
                     " J/m^2, where the traction at the plate is a tenth of Young's modulus");
}

}  // namespace rebound::fem
