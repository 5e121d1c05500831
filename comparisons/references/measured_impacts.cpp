#include "comparisons/references/measured_impacts.hpp"

#include <fmt/format.h>

#include "comparisons/dataset/read_dataset.hpp"
#include "comparisons/references/measured_shot.hpp"
#include "comparisons/references/read_references.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

/// Fills in what nothing states, and says so.
void assume(MeasuredImpact& impact, const AssumedUncertainty& assumed, const std::string& label,
            std::vector<std::string>& notes) {
  if (!(impact.restitution_uncertainty > 0.0)) {
    impact.restitution_uncertainty = assumed.restitution;
    notes.push_back(fmt::format("{}: uncertainty of the restitution assumed, {:g}", label,
                                assumed.restitution));
  }
  if (!(impact.contact_time_uncertainty > 0.0)) {
    impact.contact_time_uncertainty = assumed.contact_time * impact.contact_time;
    notes.push_back(fmt::format("{}: uncertainty of the contact time assumed, {:g} %", label,
                                100.0 * assumed.contact_time));
  }
}

MeasuredImpact impact_of(const Dataset& data, const Shot& shot, const std::string& label) {
  MeasuredImpact impact{.impact = {.speed = shot.speed},
                        .restitution_uncertainty = shot.restitution.uncertainty.value_or(0.0),
                        .contact_time_uncertainty = shot.contact_time.uncertainty.value_or(0.0),
                        .contact_threshold = data.instrument.contact_threshold.value_or(0.0)};
  if (!shot.trace && !(shot.restitution.value && shot.contact_time.value))
    throw Error(ExitCode::bad_input,
                label + ": a material needs restitution and contact time, or a trace that has them",
                {.file = data.folder, .key = "shot"});
  if (shot.trace) {
    const ReferenceShot seen = measured_shot(data, shot);
    impact.restitution = seen.scalars.restitution;
    impact.contact_time = time_above(seen.trace, impact.contact_threshold);
  }
  if (shot.restitution.value) impact.restitution = *shot.restitution.value;
  if (shot.contact_time.value) impact.contact_time = *shot.contact_time.value;
  return impact;
}

}  // namespace

MeasuredBall measured_ball(const std::filesystem::path& folder, const AssumedUncertainty& assumed) {
  MeasuredBall ball;
  const auto add = [&](MeasuredImpact impact, const std::string& label) {
    assume(impact, assumed, label, ball.notes);
    ball.impacts.push_back(impact);
    ball.labels.push_back(label);
  };
  if (std::filesystem::exists(folder / "dataset.toml")) {
    const Dataset data = read_dataset(folder);
    ball.sphere = data.sphere;
    for (const Shot& shot : data.shots) {
      const std::string label = fmt::format("{} {:g} m/s", data.name, shot.speed);
      add(impact_of(data, shot, label), label);
    }
    return ball;
  }
  for (const BenchmarkReference& reference : read_references(folder)) {
    ball.sphere = reference.shot.sphere;
    add({.impact = {.speed = reference.shot.impact.speed},
         .restitution = reference.shot.scalars.restitution,
         .contact_time = time_above(reference.shot.trace, 0.0)},
        reference.label);
  }
  return ball;
}

MeasuredBall measured_histories(const std::filesystem::path& folder,
                                const AssumedUncertainty& assumed) {
  constexpr std::size_t most_samples = 200;
  MeasuredBall ball;
  for (const BenchmarkReference& reference : read_references(folder)) {
    const ReferenceShot& shot = reference.shot;
    ball.sphere = shot.sphere;
    MeasuredImpact impact{.impact = {.speed = shot.impact.speed},
                          .force_uncertainty = shot.force_uncertainty};
    if (!(impact.force_uncertainty > 0.0)) {
      impact.force_uncertainty = assumed.force * shot.scalars.peak_force;
      ball.notes.push_back(fmt::format("{}: uncertainty of the force assumed, {:g} % of its peak",
                                       reference.label, 100.0 * assumed.force));
    }
    const std::size_t every = 1 + shot.trace.time.size() / most_samples;
    for (std::size_t i = 0; i < shot.trace.time.size(); i += every) {
      impact.trace.time.push_back(shot.trace.time[i]);
      impact.trace.force.push_back(shot.trace.force[i]);
    }
    ball.impacts.push_back(std::move(impact));
    ball.labels.push_back(reference.label);
  }
  return ball;
}

}  // namespace rebound
