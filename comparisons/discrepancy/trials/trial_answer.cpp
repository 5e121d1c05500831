#include "comparisons/discrepancy/trials/trial_answer.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "comparisons/models/effects/effect.hpp"

namespace rebound {
namespace {

bool any_in_candidates(const TrialAnswer& answer,
                       const std::function<bool(const std::string&)>& is_it) {
  return std::any_of(answer.candidates.begin(), answer.candidates.end(), [&](const auto& names) {
    return std::any_of(names.begin(), names.end(), is_it);
  });
}

}  // namespace

bool is_missing(const TrialAnswer& answer) {
  return answer.verdict == "failed";
}

bool says_gap(const TrialAnswer& answer) {
  return answer.verdict != "agrees" && answer.verdict != "insufficient-data" && !is_missing(answer);
}

std::string family_said(const TrialAnswer& answer) {
  return answer.verdict == "measurement-fault" ? "measurement" : answer.family;
}

bool in_a_candidate(const TrialAnswer& answer, const std::string& name) {
  return any_in_candidates(
      answer, [&](const std::string& one) { return one == name || effect_behind(one) == name; });
}

bool family_in_a_candidate(const TrialAnswer& answer, const std::string& family) {
  return any_in_candidates(answer, [&](const std::string& name) {
    return name_of(find_effect(name).card.family) == family;
  });
}

bool are_in_a_candidate(const TrialAnswer& answer, const std::string& family,
                        const std::string& other) {
  std::vector<std::vector<std::string>> sets = answer.candidate_families;
  if (sets.empty())
    for (const auto& names : answer.candidates) {
      auto& families = sets.emplace_back();
      for (const std::string& name : names)
        families.emplace_back(name_of(find_effect(name).card.family));
    }
  const auto [lesser, greater] = std::minmax(family, other);
  return std::any_of(sets.begin(), sets.end(), [&](auto& families) {
    std::sort(families.begin(), families.end());
    const std::array wanted{lesser, greater};  // two members where both are of one family
    return std::includes(families.begin(), families.end(), wanted.begin(), wanted.end());
  });
}

bool name_is_said(const TrialAnswer& answer, const std::string& name) {
  return answer.named == name || in_a_candidate(answer, name);
}

bool formula_is_said(const TrialAnswer& answer, const std::string& name) {
  return answer.named == name ||
         any_in_candidates(answer, [&](const std::string& one) { return one == name; });
}

TrialAnswer answer_of_set(const std::vector<std::string>& names, const std::string& family) {
  if (names.empty()) return {.verdict = "agrees", .family = {}, .candidates = {}, .named = {}};
  TrialAnswer answer{.verdict = "missing", .family = family, .candidates = {names}, .named = {}};
  const bool free_form = names.size() == 1 && find_effect(names.front()).card.is_free_form;
  if (std::all_of(names.begin(), names.end(), is_measurement))
    answer.verdict = "measurement-fault";
  else if (free_form)
    answer.verdict = "family";
  if (names.size() == 1 && !free_form) answer.named = names.front();
  return answer;
}

}  // namespace rebound
