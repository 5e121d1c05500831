#include "comparisons/study/study_laws.hpp"

#include <fmt/format.h>

namespace rebound {
namespace {

/// The trace up to the end of contact: a law is fitted to the impact alone.
ReferenceShot reference_of(const StudyShot& shot) {
  ReferenceShot reference{.sphere = shot.problem.sphere,
                          .impact = shot.problem.impact,
                          .trace = {},
                          .scalars = shot.fem.scalars};
  const Trace& trace = shot.fem.trace;
  for (std::size_t i = 0; i < trace.time.size() && trace.time[i] <= shot.fem.scalars.contact_time;
       ++i) {
    reference.trace.time.push_back(trace.time[i]);
    reference.trace.force.push_back(trace.force[i]);
    reference.trace.deflection.push_back(trace.deflection[i]);
  }
  return reference;
}

std::vector<ReferenceShot> references_of(const CoreStudy& core) {
  std::vector<ReferenceShot> references;
  for (const auto& shot : core.shots) references.push_back(reference_of(shot));
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
  std::vector<BenchmarkReference> references;
  for (const auto& shot : core.shots)
    references.push_back({.label = fmt::format("{} {:g} m/s", core.label, shot.measured.speed),
                          .shot = reference_of(shot),
                          .measured = {.restitution = shot.measured.restitution.value,
                                       .contact_time = shot.measured.contact_time.value,
                                       .peak_force = shot.measured.peak_force.value,
                                       .peak_deflection = shot.measured.peak_deflection.value,
                                       .mean_deflection = shot.measured.mean_deflection.value}});
  return benchmark(entries, references, control);
}

}  // namespace rebound
