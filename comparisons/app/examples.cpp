#include "comparisons/app/examples.hpp"

namespace rebound {
namespace {

constexpr Sphere core_a{.mass = 89.6e-3, .diameter = 66.2e-3};

}  // namespace

LumpedProblem example_lumped_problem() {
  LumpedProblem problem;
  problem.sphere = core_a;
  problem.impact.speed = 15.0;
  problem.model.law = "hunt-crossley";
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 17.63e4}};
  return problem;
}

FemProblem example_fem_problem() {
  FemProblem problem;
  problem.sphere = core_a;
  problem.impact.speed = 15.0;
  problem.material.youngs_modulus = 10e6;
  problem.material.poisson_ratio = 0.4;
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 0.3e-3}};
  return problem;
}

CompressionProblem example_compression() {
  CompressionProblem problem;
  problem.sphere = core_a;
  problem.compression = {.platens = 2, .deflection = 16e-3, .steps = 64};
  problem.material.youngs_modulus = 3.6e6;
  problem.material.poisson_ratio = 0.4;
  problem.material.modulus = ModulusBasis::long_term;
  return problem;
}

SynthesisFile example_synthesis() {
  SynthesisFile file;
  file.name = "relaxation hidden in core A";
  file.sphere = core_a;
  file.lumped.parameters = {{"exponent", 1.5}, {"stiffness", 3.2e6}, {"damping", 7e4}};
  file.effects = {{.name = "relaxation", .size = 0.4, .parameters = {{"relaxation_time", 0.5e-3}}}};
  file.instrument.force_noise = 20.0;
  file.instrument.force_gain_uncertainty = 0.01;
  for (const double speed : {5.0, 15.0, 25.0})
    file.shots.push_back({.speed = speed, .speed_uncertainty = 0.004 * speed});
  return file;
}

Dataset example_dataset() {
  Dataset dataset;
  dataset.name = "sliotar core A on the rigid plate";
  dataset.sphere = core_a;
  dataset.mass_uncertainty = 0.4e-3;
  dataset.instrument.force_noise = 10.0;
  dataset.instrument.force_gain_uncertainty = 0.03;
  dataset.instrument.camera_rate = 4000.0;
  dataset.instrument.deflection = DeflectionOrigin::integrated;
  dataset.shots.push_back({.impact = {.speed = 15.0},
                           .restitution = {.value = 0.527, .uncertainty = 0.01},
                           .contact_time = {.value = 1.91e-3, .uncertainty = 0.03e-3}});
  dataset.quasistatic.push_back({.platens = 2, .stiffness = {.value = 4.053e5}});
  return dataset;
}

CalibrationFile example_calibration() {
  CalibrationFile file;
  file.request.law = "hunt-crossley";
  file.references = {{"reference"}};
  return file;
}

SelectionFile example_selection() {
  SelectionFile file;
  file.candidates = {{.label = "Hunt-Crossley", .request = {.law = "hunt-crossley"}},
                     {.label = "Kuwabara-Kono", .request = {.law = "kuwabara-kono"}}};
  file.references = {{"reference"}};
  return file;
}

BenchmarkFile example_benchmark() {
  BenchmarkFile file;
  file.rows = {
      {.label = "as it stands", .file = "lumped.toml", .request = {}},
      {.label = "Kelvin-Voigt, fitted", .file = "", .request = {.law = "linear-kelvin-voigt"}}};
  file.references = {{"reference"}};
  return file;
}

CompareFile example_comparison() {
  CompareFile file;
  file.cases = {{.name = "first",
                 .lumped = "lumped.toml",
                 .fem = "fem.toml",
                 .speeds = {"5 m/s", "15 m/s"},
                 .agreement = {}}};
  return file;
}

CampaignFile example_campaign() {
  CampaignFactor speed;
  speed.key = "impact.speed";
  speed.about.unit = "m/s";
  speed.low = 1.0;
  speed.high = 30.0;
  speed.points = 20;
  return {.base = "lumped.toml", .design = {.factors = {speed}, .known = {}}};
}

}  // namespace rebound
