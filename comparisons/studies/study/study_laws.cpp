#include "comparisons/studies/study/study_laws.hpp"

#include <fmt/format.h>

#include "comparisons/inference/references/contact_alone.hpp"

namespace rebound {
namespace {

/// What laws are fitted to and scored against: the FE impact up to separation, and beside it
/// what was measured.
std::vector<MeasuredImpact> references_of(const CoreStudy& core) {
  std::vector<MeasuredImpact> references;
  for (const auto& shot : core.shots) {
    MeasuredImpact reference =
        contact_alone(shot.problem.sphere, shot.problem.impact, shot.fem.trace, shot.fem.scalars);
    reference.label = fmt::format("{} {:g} m/s", core.label, shot.measured.impact.speed);
    for (const ScalarQuantity& scalar : scalar_quantities)
      reference.*scalar.measured = shot.measured.*scalar.measured;
    references.push_back(std::move(reference));
  }
  return references;
}

/// The paper's κ and λ, as printed.
LumpedModel published_model(const CoreStudy& core) {
  LumpedModel model;
  model.law = "hunt-crossley";
  model.parameters["stiffness"] = core.published.hunt_crossley_stiffness.value;
  for (const auto& at : core.published.at_speed)
    model.at_speed.push_back({at.speed, {{"damping", at.hunt_crossley_damping.value}}});
  return model;
}

}  // namespace

void calibrate_laws(CoreStudy& core) {
  const auto references = references_of(core);
  core.laws.push_back({"Hunt–Crossley, as published",
                       "stiffness and damping of the paper's Table 3, taken over",
                       published_model(core), std::nullopt});

  const auto eq8 = calibrate_hunt_crossley(references, "hunt-crossley");
  core.laws.push_back({"Hunt–Crossley, Eq. (8)",
                       "one stiffness fitted to the FE force–deflection curves; damping by the "
                       "low-loss formula Eq. (8)",
                       eq8.model, eq8.fit});
  const auto exact = calibrate_hunt_crossley(references, "exact");
  core.laws.push_back({"Hunt–Crossley, exact",
                       "one stiffness fitted to the FE force–deflection curves; damping by the "
                       "exact relation",
                       exact.model, exact.fit});
  core.laws.push_back({"equivalent Kelvin–Voigt",
                       "the Eq. (8) law frozen at the mean deflection of each FE impact, Eq. (15)",
                       linearise_at_mean_deflection(eq8.model, references), std::nullopt});
  const auto fit_freely = [&](const char* label, const char* law, const char* origin) {
    const auto fitted = calibrate_law(law, references, {});
    core.laws.push_back({label, origin, fitted.model, fitted.fit});
  };
  fit_freely("linear Kelvin–Voigt", "linear-kelvin-voigt",
             "one stiffness and one damping fitted to the FE force–deflection curves");
  fit_freely("Hertz-damped", "hertz-damped",
             "Eq. (5): one stiffness and one damping fitted to the FE force–deflection curves");
  fit_freely("power law", "power-law",
             "Eq. (3): stiffness, damping and both exponents fitted to the FE force–deflection "
             "curves");
}

BenchmarkMatrix score_laws(const CoreStudy& core, const RunControl& control) {
  std::vector<BenchmarkEntry> entries;
  for (const auto& law : core.laws) entries.push_back({law.label, law.model});
  return benchmark(entries, references_of(core), control);
}

}  // namespace rebound
