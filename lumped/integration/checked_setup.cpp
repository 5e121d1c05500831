#include "lumped/integration/checked_setup.hpp"

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

// Fewer samples leave the parabola through the highest one a poor peak.
constexpr int fewest_samples = 50;
constexpr int most_samples = 1'000'000;

}  // namespace

ContactSetup checked_setup(const LumpedProblem& problem) {
  const auto& controls = problem.controls;
  if (!(controls.relative_tolerance >= 1e-13 && controls.relative_tolerance <= 1e-4))
    throw Error(ExitCode::bad_input, "relative tolerance out of range",
                {.key = "controls.relative_tolerance",
                 .value = std::to_string(controls.relative_tolerance),
                 .allowed = "[1e-13, 1e-4]"});
  if (controls.samples < fewest_samples || controls.samples > most_samples)
    throw Error(ExitCode::bad_input, "number of samples out of range",
                {.key = "controls.samples", .value = std::to_string(controls.samples),
                 .allowed = "[50, 1000000]"});
  return {.mass = problem.sphere.mass, .speed = problem.impact.speed,
          .separation = problem.impact.separation,
          .relative_tolerance = controls.relative_tolerance};
}

}  // namespace rebound
