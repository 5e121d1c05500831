#include "comparisons/discrepancy/design/test_design.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/discrepancy/design/planned_data.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/excluded_sizes.hpp"
#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double surplus = 1.2815515655446004;  // Φ⁻¹(0.9)
constexpr double alike = 0.99;  // cosine from which two effects are one in these data

void check_plan(const SynthesisFile& plan) {
  if (plan.tier == Tier::fem)
    throw Error(ExitCode::bad_input, "a test is designed around a lumped model",
                {.key = "model.tier", .value = "fem", .allowed = "lumped"});
  if (!plan.effects.empty())
    throw Error(
        ExitCode::bad_input,
        "a design asks what would be found beside the model, so nothing may be hidden in it",
        {.key = "model.effect", .value = plan.effects.front().name, .allowed = "no effect"});
}

/// The direction of an effect that the fit absorbs least.
const EffectSensitivity* clearest(const EffectSensitivities& around, const std::string& name) {
  const EffectSensitivity* best = nullptr;
  for (const EffectSensitivity& one : around.all())
    if (one.effect.name == name && (!best || one.absorbed < best->absorbed)) best = &one;
  return best;
}

void find_rival(const EffectSensitivities& around, FindableEffect& effect) {
  const EffectSensitivity* own = clearest(around, effect.name);
  if (!own) return;
  const Eigen::VectorXd direction = own->sensitivity.normalized();
  for (const EffectSensitivity& other : around.all()) {
    if (other.effect.name == effect.name) continue;
    const double cosine = std::abs(direction.dot(other.sensitivity.normalized()));
    if (cosine <= effect.cosine) continue;
    effect.cosine = cosine;
    effect.rival = other.effect.name;
  }
}

FindableEffect findable(const EffectSensitivities& around, const std::string& name,
                        double threshold, double close_criterion) {
  FindableEffect effect{.name = name};
  const EffectCard& card = find_effect(name).card;
  const auto size_at = [&](double rise) -> std::optional<double> {
    const auto found = size_that_raises(around, card, rise);
    if (!found) return std::nullopt;
    return found->size;
  };
  const double found_rise = std::pow(std::sqrt(threshold) + surplus, 2);
  effect.found = size_at(found_rise);
  find_rival(around, effect);
  if (!effect.found || effect.cosine > alike) return effect;
  const double apart = std::pow(surplus + std::sqrt(surplus * surplus + close_criterion), 2);
  effect.told_apart = size_at(std::max(found_rise, apart / (1.0 - effect.cosine * effect.cosine)));
  return effect;
}

/// Error of each effect's size, at the numbers at which it is clearest.
std::map<std::string, double> size_errors(const EffectSensitivities& around) {
  std::map<std::string, double> errors;
  for (const std::string& name : around.effects())
    if (const EffectSensitivity* one = clearest(around, name)) errors[name] = one->size_error();
  return errors;
}

DesignChange compare(const std::string& what, const std::map<std::string, double>& before,
                     const std::map<std::string, double>& after) {
  DesignChange change{.what = what};
  double logarithms = 0.0;
  int count = 0;
  for (const auto& [name, error] : before) {
    const auto found = after.find(name);
    if (found == after.end()) continue;
    const double ratio = found->second / error;
    logarithms += std::log(ratio);
    ++count;
    if (ratio >= change.smallest_ratio) continue;
    change.smallest_ratio = ratio;
    change.helps_most = name;
  }
  if (count > 0) change.size_error_ratio = std::exp(logarithms / count);
  return change;
}

std::vector<std::string> with_a_size(const EffectSensitivities& around) {
  std::vector<std::string> names;
  for (const std::string& name : around.effects()) {
    const EffectCard& card = find_effect(name).card;
    if (!card.is_switch && std::isfinite(card.null) && clearest(around, name))
      names.push_back(name);
  }
  return names;
}

}  // namespace

TestDesign design_test(const SynthesisFile& plan, std::uint64_t seed, const RunControl& control) {
  check_plan(plan);
  const auto continue_at = [&](double fraction) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted while the plan was examined");
    if (control.progress) control.progress(fraction);
  };
  const SelectionRules rules;
  const PlannedData data = planned_data(plan);
  TestDesign design{.shots = static_cast<int>(data.seen->shots.size()),
                    .gap_threshold = data.around->threshold(rules.false_gap_level, seed)};
  constexpr double own_share = 0.5;
  continue_at(0.1);
  const std::vector<std::string> names = with_a_size(*data.around);
  design.effects.resize(names.size());
  in_parallel(names.size(), [&](std::size_t i) {
    if (control.interrupted && control.interrupted()) return;
    design.effects[i] =
        findable(*data.around, names[i], design.gap_threshold, rules.close_criterion);
  });
  continue_at(own_share);
  const std::map<std::string, double> before = size_errors(*data.around);
  const std::vector<ChangedPlan> changed = changed_plans(plan);
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const PlannedData other = planned_data(changed[i].plan);
    design.changes.push_back(compare(changed[i].what, before, size_errors(*other.around)));
    continue_at(own_share + (1.0 - own_share) * static_cast<double>(i + 1) /
                                static_cast<double>(changed.size()));
  }
  std::stable_sort(design.changes.begin(), design.changes.end(),
                   [](const DesignChange& a, const DesignChange& b) {
                     return a.size_error_ratio < b.size_error_ratio;
                   });
  return design;
}

}  // namespace rebound
