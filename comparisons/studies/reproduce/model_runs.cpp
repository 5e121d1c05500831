#include "comparisons/studies/reproduce/model_runs.hpp"

#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

LumpedProblem problem_of(const std::vector<double>& inputs, const PaperCore& core, double speed) {
  return {.sphere = {.mass = inputs[2], .diameter = core.diameter.value},
          .impact = {.speed = speed},
          .model = {.law = "hunt-crossley",
                    .parameters = {{"stiffness", inputs[0]}, {"damping", inputs[1]}}},
          .controls = {}};
}

}  // namespace

LumpedProblem published_problem(const PaperCore& core, const PaperShot& shot) {
  return problem_of({core.published.hunt_crossley_stiffness.value,
                     shot.published.hunt_crossley_damping.value, core.mass.value},
                    core, shot.speed);
}

std::vector<std::vector<ModelRun>> run_published_model(const Paper& paper) {
  std::vector<std::vector<ModelRun>> runs;
  for (const PaperCore& core : paper.cores) {
    runs.emplace_back();
    for (const PaperShot& shot : core.shots) {
      const auto range_of = [&](double ImpactScalars::*scalar) {
        return corner_range(
            [&](const std::vector<double>& inputs) {
              return simulate_fast(problem_of(inputs, core, shot.speed)).scalars.*scalar;
            },
            {core.published.hunt_crossley_stiffness, shot.published.hunt_crossley_damping,
             core.mass});
      };
      runs.back().push_back({.result = simulate_fast(published_problem(core, shot)),
                             .contact_time = range_of(&ImpactScalars::contact_time),
                             .peak_force = range_of(&ImpactScalars::peak_force),
                             .peak_deflection = range_of(&ImpactScalars::peak_deflection)});
    }
  }
  return runs;
}

std::vector<StudyRun> run_parameter_study(const ParameterStudy& study, int steps) {
  std::vector<StudyRun> runs;
  for (int i = 0; i <= steps; ++i) {
    LumpedProblem problem;
    // A ball of usual size: the paper names none, and the bare law does not ask for it.
    problem.sphere = {.mass = study.mass, .diameter = 0.066};
    problem.impact.speed = study.speed;
    const double stiffness =
        study.lowest_stiffness + (study.highest_stiffness - study.lowest_stiffness) * i / steps;
    problem.model.parameters = {{"stiffness", stiffness}};
    problem.model.restitution = study.restitution;
    problem.model.damping_formula = "hunt-crossley";  // Eq. (8)
    runs.push_back({stiffness, simulate_fast(problem)});
  }
  return runs;
}

}  // namespace rebound
