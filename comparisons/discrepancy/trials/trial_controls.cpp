#include "comparisons/discrepancy/trials/trial_controls.hpp"

#include <algorithm>
#include <random>

#include "comparisons/discrepancy/trials/sparse_regression.hpp"
#include "comparisons/io/results/digest.hpp"

namespace rebound {
namespace {

std::string family_of_effect(const std::string& name) {
  return name_of(find_effect(name).card.family);
}

/// Of a set, the family of the member that has the lowest criterion when it stands alone; of the
/// first where none was tried alone.
std::string leading_family(const Diagnosis& d, const std::vector<std::string>& set) {
  for (const AssessedFit& one : d.selection.tried) {  // best criterion first
    const std::vector<std::string> alone = added_effects(one.fit, d.believed_effects);
    if (alone.size() == 1 && std::find(set.begin(), set.end(), alone.front()) != set.end())
      return family_of_effect(alone.front());
  }
  return set.empty() ? std::string() : family_of_effect(set.front());
}

TrialAnswer not_enough_data() {
  return {.verdict = name_of(DiagnosisVerdict::insufficient_data),
          .family = {},
          .candidates = {},
          .named = {}};
}

bool is_fitted(const Diagnosis& d) {
  return !d.believed.fit.values.empty();
}

}  // namespace

TrialAnswer lowest_information_criterion(const Diagnosis& d) {
  if (!is_fitted(d)) return not_enough_data();
  const HypothesisFit* best = &d.selection.baseline.fit;
  for (const AssessedFit& one : d.selection.tried)
    if (one.fit.information_criterion < best->information_criterion) best = &one.fit;
  const std::vector<std::string> names = added_effects(*best, d.believed_effects);
  return answer_of_set(names, leading_family(d, names));
}

TrialAnswer sparse_regression_answer(const Diagnosis& d) {
  if (!is_fitted(d) || d.believed.fit.model->fem() != nullptr) return not_enough_data();
  const EffectFamily family = regress_residual_force(*d.seen, d.believed.fit).family;
  if (family == EffectFamily::none) return answer_of_set({}, {});
  return {
      .verdict = name_of(family == EffectFamily::measurement ? DiagnosisVerdict::measurement_fault
                                                             : DiagnosisVerdict::family),
      .family = name_of(family),
      .candidates = {},
      .named = {}};
}

TrialAnswer random_answer(const Diagnosis& d, std::uint64_t seed, const std::string& data) {
  std::map<EffectFamily, std::vector<std::string>> feasible;
  std::vector<EffectChoice> present;
  if (is_fitted(d))
    present.assign(
        d.believed.fit.effects.begin(),
        d.believed.fit.effects.begin() + static_cast<std::ptrdiff_t>(d.believed_effects));
  for (const std::string& name : absent_effects(present))
    feasible[find_effect(name).card.family].push_back(name);
  std::erase_if(feasible, [](const auto& one) {
    return one.first == EffectFamily::none || one.second.empty();
  });
  const std::string digest = sha256(data + std::to_string(seed));
  std::seed_seq words(digest.begin(), digest.end());
  std::mt19937_64 random(words);
  const auto drawn = random() % (feasible.size() + 1);  // one answer of all is "agrees"
  if (drawn == feasible.size()) return answer_of_set({}, {});
  const auto& [family, names] = *std::next(feasible.begin(), static_cast<std::ptrdiff_t>(drawn));
  return answer_of_set({names[random() % names.size()]}, name_of(family));
}

std::map<std::string, TrialAnswer> answers_of_controls(const Diagnosis& d, std::uint64_t seed,
                                                       const std::string& data) {
  return {{control_names[0].key, lowest_information_criterion(d)},
          {control_names[1].key, sparse_regression_answer(d)},
          {control_names[2].key, random_answer(d, seed, data)}};
}

}  // namespace rebound
