#include "comparisons/discrepancy/diagnosis/verdict/candidate_family.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rebound {
namespace {

EffectFamily family_of(const FamilySet& candidate) {
  EffectFamily family = EffectFamily::none;
  for (const EffectFamily own : candidate) {
    if (family != EffectFamily::none && own != family) return EffectFamily::none;
    family = own;
  }
  return family;
}

bool has_member(const FamilySet& candidate, EffectFamily family) {
  return std::find(candidate.begin(), candidate.end(), family) != candidate.end();
}

/// What the best fit of each family explains by itself.
std::map<EffectFamily, double> largest_shares(const std::vector<ExplainedShare>& explained) {
  std::map<EffectFamily, double> shares;
  for (const ExplainedShare& one : explained)
    if (const EffectFamily family = family_of(one.families); family != EffectFamily::none)
      shares[family] = std::max(shares[family], one.share);
  return shares;
}

}  // namespace

EffectFamily common_family(const std::vector<FamilySet>& candidates) {
  const EffectFamily first = family_of(candidates.front());
  const bool same = std::all_of(candidates.begin(), candidates.end(),
                                [&](const auto& one) { return family_of(one) == first; });
  return same ? first : EffectFamily::none;
}

EffectFamily main_family(const std::vector<FamilySet>& candidates,
                         const std::vector<ExplainedShare>& explained) {
  constexpr double most = 0.8, half = 0.5, hardly_any = 0.125;
  constexpr double far_less = 0.25;  // of what another leaves
  const std::map<EffectFamily, double> shares = largest_shares(explained);
  std::vector<std::pair<double, EffectFamily>> left;
  for (const auto& one : shares) {
    const EffectFamily family = one.first;
    const double share = one.second;
    const bool in_all =
        std::all_of(candidates.begin(), candidates.end(),
                    [&](const auto& candidate) { return has_member(candidate, family); });
    const bool is_alone = std::all_of(shares.begin(), shares.end(), [&](const auto& other) {
      return other.first == family || other.second < hardly_any;
    });
    if (in_all && share >= (is_alone ? half : most)) left.emplace_back(1.0 - share, family);
  }
  std::sort(left.begin(), left.end());
  const bool stands_out =
      !left.empty() && (left.size() == 1 || left[0].first <= far_less * left[1].first);
  return stands_out ? left.front().second : EffectFamily::none;
}

std::vector<ExplainedShare> nearest_formulas(EffectFamily family,
                                             const std::vector<ExplainedShare>& explained) {
  constexpr double worth_a_word = 0.5;
  constexpr std::size_t most = 2;
  std::vector<ExplainedShare> nearest;
  for (const ExplainedShare& one : explained) {
    if (one.effects.size() != 1 || one.share < worth_a_word) continue;
    const EffectCard& card = find_effect(one.effects.front()).card;
    if (card.family == family && !card.is_free_form) nearest.push_back(one);
  }
  std::stable_sort(nearest.begin(), nearest.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  if (nearest.size() > most) nearest.resize(most);
  return nearest;
}

}  // namespace rebound
