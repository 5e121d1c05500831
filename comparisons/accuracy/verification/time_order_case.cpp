#include <fmt/format.h>

#include <cmath>

#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound {
namespace {

/// A short cylinder whose flat end lands whole and stays: the motion is smooth.
/// Deflections at fixed instants until it is stopped, well before it leaves.
class Landing {
 public:
  Landing(const FemTier& tier, FemScheme scheme, const RunControl& control)
      : tier_(tier), control_(control), problem_(ball_problem(scheme, 1.0)) {
    problem_.sphere.diameter = 2.0 * radius;
    problem_.controls.output_interval = interval();
    problem_.controls.end_time = 10.0 * interval();
  }

  /// Between samples, which fall on the ends of steps [s].
  static double interval() { return contact_time() / 50.0; }

  /// `steps` of equal length to a sample.
  std::vector<double> deflections(int steps) {
    if (problem_.scheme == FemScheme::explicit_steps)
      problem_.controls.largest_step = interval() / steps;
    else
      problem_.controls.step_safety = 180.0 / 50.0 / steps;  // of a 180th of the contact time
    const FemResult result =
        tier_.simulate(problem_, mesh_, {.interrupted = control_.interrupted, .progress = {}});
    if (result.incomplete_because != "the contact had not ended by the end time")
      require_complete(result.incomplete_because, control_, "landing of a cylinder");
    return result.trace.deflection;
  }

 private:
  static constexpr double radius = 0.02;  // [m]
  /// What Hertz expects of a sphere of that radius: the unit that steps are asked for in [s].
  static double contact_time() {
    const double plane_strain =
        targets::ball_modulus / (1.0 - targets::ball_poisson_ratio * targets::ball_poisson_ratio);
    return 2.8682657 * std::pow(targets::ball_mass * targets::ball_mass /
                                    (radius * plane_strain * plane_strain * 1.0),
                                0.2);
  }

  const FemTier& tier_;
  const RunControl& control_;
  FemProblem problem_;
  Mesh mesh_ =
      cylinder_mesh({.radius = radius, .length = 0.04, .cells_across = 1, .cells_along = 2});
};

Refinement time_refinement(const FemTier& tier, FemScheme scheme, const RunControl& control) {
  const bool implicit = scheme == FemScheme::implicit_steps;
  Landing landing(tier, scheme, control);
  const int fewest = 8;
  const auto exact = landing.deflections(32 * fewest);
  Refinement steps{.name = fmt::format("the {} scheme in time", implicit ? "implicit" : "explicit"),
                   .size = {},
                   .error = {},
                   .expected_order = 2.0,
                   .tolerance = 0.15};
  for (int count = fewest; count <= 4 * fewest; count *= 2) {
    const auto found = landing.deflections(count);
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(found.size(), exact.size()); ++i)
      sum += (found[i] - exact[i]) * (found[i] - exact[i]);
    steps.size.push_back(Landing::interval() / count);
    steps.error.push_back(std::sqrt(sum / static_cast<double>(exact.size())));
  }
  return steps;
}

}  // namespace

VerificationPart verify_time_order(const FemTier& tier, const RunControl& control) {
  VerificationPart part;
  std::vector<Refinement> drawn;
  for (const FemScheme scheme : {FemScheme::explicit_steps, FemScheme::implicit_steps}) {
    drawn.push_back(time_refinement(tier, scheme, control));
    part.rows.push_back(order_row("a", drawn.back(), "central differences, generalised-alpha"));
  }
  part.figures = {refinement_figure({.title = "Order in time",
                                     .caption = "Case a: a short cylinder lands on its flat end; "
                                                "deflection against steps 32 times as short.",
                                     .size = {"time step", "s"},
                                     .error = {"error of the deflection", "m"}},
                                    drawn)};
  return part;
}

}  // namespace rebound
