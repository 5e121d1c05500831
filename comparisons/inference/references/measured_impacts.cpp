#include "comparisons/inference/references/measured_impacts.hpp"

#include <fmt/format.h>

#include "comparisons/inference/references/contact_alone.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Fills in what nothing states, and says so.
void assume(MeasuredImpact& impact, const AssumedUncertainty& assumed) {
  if (!impact.restitution.has_error()) {
    impact.restitution.uncertainty = assumed.restitution;
    impact.assumed.push_back(fmt::format("{}: uncertainty of the restitution assumed, {:g}",
                                         impact.label, assumed.restitution));
  }
  if (!impact.contact_time.has_error()) {
    impact.contact_time.uncertainty = assumed.contact_time * *impact.contact_time.value;
    impact.assumed.push_back(fmt::format("{}: uncertainty of the contact time assumed, {:g} %",
                                         impact.label, 100.0 * assumed.contact_time));
  }
}

/// Restitution and contact time from the trace, where nothing states them.
void take_from_trace(MeasuredImpact& impact) {
  const MeasuredImpact seen = contact_alone(impact);
  if (!impact.restitution.value) impact.restitution.value = seen.scalars.restitution;
  if (!impact.contact_time.value)
    impact.contact_time.value = reported_contact_time(seen.trace, seen.scalars.contact_time,
                                                      impact.contact_threshold.value_or(0.0));
  impact.trace = {};
}

MeasuredImpact impact_of(const Dataset& data, const MeasuredImpact& shot) {
  MeasuredImpact impact = completed(data, shot);
  impact.label = fmt::format("{} {:g} m/s", data.name, shot.impact.speed);
  if (impact.has_history()) take_from_trace(impact);
  if (!impact.restitution.value || !impact.contact_time.value)
    throw Error(
        ExitCode::bad_input,
        impact.label + ": a material needs restitution and contact time, or a trace that has them",
        {.file = data.folder, .key = "shot"});
  return impact;
}

}  // namespace

std::vector<MeasuredImpact> measured_scalars(const std::filesystem::path& folder,
                                             const AssumedUncertainty& assumed) {
  std::vector<MeasuredImpact> impacts;
  if (std::filesystem::exists(folder / "dataset.toml")) {
    const Dataset data = read_dataset(folder);
    for (const MeasuredImpact& shot : data.shots) impacts.push_back(impact_of(data, shot));
  } else {
    impacts = read_references(folder);
    for (MeasuredImpact& impact : impacts) {
      impact.restitution.value = impact.scalars.restitution;
      impact.contact_time.value = impact.scalars.contact_time;
      impact.trace = {};
    }
  }
  if (impacts.empty())
    throw Error(ExitCode::bad_input, "there is no impact to fit a material to",
                {.file = (folder / "dataset.toml").string(), .key = "shot"});
  for (MeasuredImpact& impact : impacts) assume(impact, assumed);
  return impacts;
}

std::vector<MeasuredImpact> measured_histories(const std::filesystem::path& folder,
                                               const AssumedUncertainty& assumed) {
  constexpr std::size_t most_samples = 200;
  std::vector<MeasuredImpact> impacts = read_references(folder);
  for (MeasuredImpact& impact : impacts) {
    if (!(impact.noise.deviation > 0.0)) {
      impact.noise.deviation = assumed.force * impact.scalars.peak_force;
      impact.assumed.push_back(
          fmt::format("{}: uncertainty of the force assumed, {:g} % of its peak", impact.label,
                      100.0 * assumed.force));
    }
    const Trace whole = std::move(impact.trace);
    impact.trace = {};
    const std::size_t every = 1 + whole.time.size() / most_samples;
    for (std::size_t i = 0; i < whole.time.size(); i += every) {
      impact.trace.time.push_back(whole.time[i]);
      impact.trace.force.push_back(whole.force[i]);
    }
  }
  return impacts;
}

}  // namespace rebound
