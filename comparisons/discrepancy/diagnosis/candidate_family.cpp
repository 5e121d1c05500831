#include "comparisons/discrepancy/diagnosis/candidate_family.hpp"

#include <algorithm>

namespace rebound {
namespace {

EffectFamily family_of(const Candidate& candidate) {
  EffectFamily family = EffectFamily::none;
  for (const std::string& name : candidate) {
    const EffectFamily own = find_effect(name).card.family;
    if (family != EffectFamily::none && own != family) return EffectFamily::none;
    family = own;
  }
  return family;
}

bool has_member(const Candidate& candidate, EffectFamily family) {
  return std::any_of(candidate.begin(), candidate.end(), [&](const std::string& name) {
    return find_effect(name).card.family == family;
  });
}

}  // namespace

EffectFamily common_family(const std::vector<Candidate>& candidates) {
  const EffectFamily first = family_of(candidates.front());
  const bool same = std::all_of(candidates.begin(), candidates.end(),
                                [&](const auto& one) { return family_of(one) == first; });
  return same ? first : EffectFamily::none;
}

EffectFamily main_family(const std::vector<Candidate>& candidates,
                         const std::vector<ExplainedShare>& explained) {
  constexpr double most = 0.8;
  EffectFamily found = EffectFamily::none;
  for (const ExplainedShare& one : explained) {
    const EffectFamily family = family_of(one.effects);
    if (family == EffectFamily::none || family == found || one.share < most) continue;
    if (!std::all_of(candidates.begin(), candidates.end(),
                     [&](const auto& candidate) { return has_member(candidate, family); }))
      continue;
    if (found != EffectFamily::none) return EffectFamily::none;
    found = family;
  }
  return found;
}

}  // namespace rebound
