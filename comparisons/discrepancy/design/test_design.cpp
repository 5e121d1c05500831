#include "comparisons/discrepancy/design/test_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/discrepancy/design/growing_effect.hpp"
#include "comparisons/discrepancy/design/planned_data.hpp"
#include "comparisons/discrepancy/design/planned_fem.hpp"
#include "comparisons/discrepancy/design/planned_pairs.hpp"
#include "comparisons/discrepancy/design/rise_of_chance.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double alike = 0.99;  // cosine from which two effects are one in these data

void check_plan(const SynthesisFile& plan) {
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

FindableEffect findable(const PlannedData& data, const RefittedChange& refitted,
                        const PlannedPairs* pairs, const PredictedDiagnosis& predicted,
                        const std::string& name, double threshold, double close_criterion) {
  FindableEffect effect{.name = name};
  find_rival(*data.around, effect);
  const GrowingEffect growing(data, refitted, pairs, name,
                              rise_of_chance(design_chance, threshold));
  if (!growing.is_found()) return effect;
  effect.chances = chances_over_size(predicted, growing);
  effect.sizes = sizes_of_chances(effect.chances);
  if (!effect.found() || effect.cosine > alike) return effect;
  const double surplus = normal_quantile(design_chance);
  const double apart = std::pow(surplus + std::sqrt(surplus * surplus + close_criterion), 2);
  if (const auto told = growing.size_of(apart / (1.0 - effect.cosine * effect.cosine)))
    effect.told_apart = std::max(*effect.found(), *told);
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

std::vector<std::string> without_form_in_fem(const std::vector<std::string>& names) {
  std::vector<std::string> without;
  for (const std::string& name : names)
    if (!find_effect(name).to_fem && !is_measurement(name)) without.push_back(name);
  return without;
}

std::vector<std::string> warnings_of(const PlannedData& data) {
  std::vector<std::string> warnings = data.seen->warnings;
  if (data.numerical_uncertainty)
    warnings.push_back(fmt::format(
        "what the mesh of the believed FE model gets wrong, {:.2g} % of the peak force, "
        "counts among the errors of the data",
        100.0 * *data.numerical_uncertainty));
  return warnings;
}

}  // namespace

std::optional<double> FindableEffect::found_with(double chance) const {
  for (const SizeOfChance& one : sizes)
    if (one.gap == chance) return one.size;
  return std::nullopt;
}

TestDesign design_test(const SynthesisFile& plan, std::uint64_t seed, const RunControl& control) {
  check_plan(plan);
  const auto continue_at = [&](double fraction) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted while the plan was examined");
    if (control.progress) control.progress(fraction);
  };
  std::optional<PlannedFem> fem;
  if (plan.tier == Tier::fem) fem.emplace(plan, control);
  continue_at(0.1);
  const SelectionRules rules;
  const PlannedData data = fem ? fem->data() : planned_data(plan);
  continue_at(0.25);
  TestDesign design{.shots = static_cast<int>(data.seen->shots.size()),
                    .gap_threshold = data.around->threshold(rules.false_gap_level, seed)};
  design.warnings = warnings_of(data);
  if (fem) design.left_out = without_form_in_fem(data.around->effects());
  const PredictedDiagnosis predicted(data, rules, seed);
  const RefittedChange refitted(data);
  std::optional<PlannedPairs> pairs;
  if (!fem) pairs.emplace(plan, data);
  design.nothing_hidden.gap = predicted.with_nothing().gap;
  constexpr double own_share = 0.6;
  const std::vector<std::string> names = with_a_size(*data.around);
  design.effects.resize(names.size());
  in_parallel(names.size(), [&](std::size_t i) {
    if (control.interrupted && control.interrupted()) return;
    design.effects[i] = findable(data, refitted, pairs ? &*pairs : nullptr, predicted, names[i],
                                 design.gap_threshold, rules.close_criterion);
  });
  continue_at(own_share);
  const auto errors_of = [&](const SynthesisFile& file) {
    const PlannedData other = fem ? fem->changed(file) : planned_data(file);
    return size_errors(*other.around);
  };
  const std::map<std::string, double> before = fem ? errors_of(plan) : size_errors(*data.around);
  const std::vector<ChangedPlan> changed = changed_plans(plan);
  for (std::size_t i = 0; i < changed.size(); ++i) {
    design.changes.push_back(compare(changed[i].what, before, errors_of(changed[i].plan)));
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
