#include "comparisons/discrepancy/design/planned_data.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double slow_factor = 0.3, fast_factor = 1.6;
constexpr double deflection_noise = 20e-6;  // of a laser or a camera at the ball [m]
constexpr double deflection_gain = 0.01;

SynthesisShot at_times(SynthesisShot shot, double factor) {
  shot.speed *= factor;
  if (shot.speed_uncertainty) *shot.speed_uncertainty *= factor;
  shot.repeats = 1;
  return shot;
}

/// Half of each stated uncertainty of a speed; false where none is stated.
bool halve_speed_errors(SynthesisFile& plan) {
  bool any = false;
  for (SynthesisShot& shot : plan.shots)
    if (shot.speed_uncertainty && *shot.speed_uncertainty > 0.0) {
      *shot.speed_uncertainty *= 0.5;
      any = true;
    }
  return any;
}

}  // namespace

void check_enough(const Observations& seen, const Hypothesis& believed) {
  if (!seen.missing.empty())
    throw Error(ExitCode::bad_input, "nothing would be told",
                {.key = "shot", .allowed = seen.missing.front()});
  const JointModel model(seen, believed);
  const auto priors = model.residuals(model.start()).size() - model.rows().size();
  if (model.rows().size() < model.unknowns().size() - priors + 2)
    throw Error(ExitCode::bad_input,
                fmt::format("the plan gives {} numbers for {} unknowns: nothing is left to tell",
                            model.rows().size(), model.unknowns().size() - priors),
                {.key = "shot", .allowed = "a force history with its noise, or further speeds"});
}

PlannedData planned_data(const SynthesisFile& plan) {
  return planned_data(plan, absent_effects({}));
}

PlannedData planned_data(const SynthesisFile& plan, const std::vector<std::string>& effects) {
  PlannedData data;
  data.seen = std::make_shared<const Observations>(
      observe({synthesize(plan, simulator_of(plan, {})).dataset}));
  const Hypothesis believed{.believed = plan.lumped, .effects = {}, .model_discrepancy = nullptr};
  check_enough(*data.seen, believed);
  data.fit = std::make_unique<const HypothesisFit>(fit_hypothesis(*data.seen, believed));
  data.around = std::make_unique<const EffectSensitivities>(*data.seen, *data.fit, effects);
  return data;
}

std::vector<ChangedPlan> changed_plans(const SynthesisFile& plan) {
  const auto [slow, fast] = std::minmax_element(
      plan.shots.begin(), plan.shots.end(),
      [](const SynthesisShot& a, const SynthesisShot& b) { return a.speed < b.speed; });
  const bool records = std::any_of(plan.shots.begin(), plan.shots.end(),
                                   [](const SynthesisShot& shot) { return shot.history; });
  std::vector<ChangedPlan> all;
  const auto add = [&](const std::string& what, const auto& change) {
    ChangedPlan one{what, plan};
    if (change(one.plan)) all.push_back(std::move(one));
  };
  for (const SynthesisShot& more : {at_times(*slow, slow_factor), at_times(*fast, fast_factor)})
    add(fmt::format("one shot more at {:.3g} m/s", more.speed), [&](SynthesisFile& file) {
      file.shots.push_back(more);
      return true;
    });
  add("every shot twice as often", [](SynthesisFile& file) {
    for (SynthesisShot& shot : file.shots) shot.repeats *= 2;
    return true;
  });
  add("half the noise of the force", [&](SynthesisFile& file) {
    if (!records || !file.instrument.force_noise) return false;
    *file.instrument.force_noise *= 0.5;
    return true;
  });
  add("the force gain known ten times as well", [&](SynthesisFile& file) {
    if (!records || !(file.instrument.force_gain_uncertainty.value_or(0.0) > 0.0)) return false;
    *file.instrument.force_gain_uncertainty *= 0.1;
    return true;
  });
  add("speeds known twice as well", halve_speed_errors);
  add(fmt::format("deflection measured to {:.0f} um beside the force", 1e6 * deflection_noise),
      [&](SynthesisFile& file) {
        if (!records || file.instrument.deflection == DeflectionOrigin::independent) return false;
        file.instrument.deflection = DeflectionOrigin::independent;
        file.instrument.deflection_noise = deflection_noise;
        file.instrument.deflection_gain_uncertainty = deflection_gain;
        return true;
      });
  return all;
}

}  // namespace rebound
