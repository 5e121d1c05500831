#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

/// The best of either criterion.
struct Criteria {
  double information = std::numeric_limits<double>::infinity();
  double prediction = std::numeric_limits<double>::infinity();

  void compare_with(const AssessedFit& one) {
    information = std::min(information, one.information_criterion());
    prediction = std::min(prediction, one.prediction_criterion());
  }
};

/// Of all adequate fits; infinite where there are none.
Criteria best_of(const std::vector<AssessedFit>& tried) {
  Criteria best;
  for (const AssessedFit& one : tried)
    if (one.adequate) best.compare_with(one);
  return best;
}

bool within_reach(const AssessedFit& one, const Criteria& best, double reach) {
  return one.information_criterion() <= best.information + reach ||
         one.prediction_criterion() <= best.prediction + reach;
}

/// Is `general` what `special` is, with a free curve in place of the formulas of its family?
bool frees_formulas_of(const HypothesisFit& general, const HypothesisFit& special) {
  EffectNames formulas = names_of(special.effects);
  for (const EffectChoice& one : general.effects) {
    const EffectCard& free = find_effect(one.name).card;
    if (!free.is_free_form || formulas.contains(one.name)) continue;
    std::erase_if(formulas, [&](const std::string& name) {
      return find_effect(name).card.family == free.family;
    });
  }
  const EffectNames own = names_of(general.effects);
  return formulas.size() < special.effects.size() &&
         std::includes(own.begin(), own.end(), formulas.begin(), formulas.end());
}

std::set<EffectFamily> families_beyond(const HypothesisFit& fit, std::size_t known) {
  std::set<EffectFamily> families;
  for (std::size_t k = known; k < fit.effects.size(); ++k)
    families.insert(find_effect(fit.effects[k].name).card.family);
  return families;
}

}  // namespace

void judge_candidates(std::vector<AssessedFit>& tried, double reach,
                      const std::function<void(AssessedFit&)>& judge) {
  constexpr std::size_t together = 4;  // whatever the number of threads, for the same answer
  for (;;) {
    const Criteria best = best_of(tried);
    std::vector<AssessedFit*> next;
    for (AssessedFit& one : tried)
      if (!one.judged && within_reach(one, best, reach) && next.size() < together)
        next.push_back(&one);
    if (next.empty()) return;
    in_parallel(next.size(), [&](std::size_t i) { judge(*next[i]); });
  }
}

std::vector<std::size_t> indistinguishable_models(const std::vector<AssessedFit>& tried,
                                                  double reach) {
  const Criteria best = best_of(tried);
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < tried.size(); ++i)
    if (tried[i].adequate && within_reach(tried[i], best, reach)) members.push_back(i);
  return smallest_of(tried, members);
}

std::vector<std::size_t> smallest_of(const std::vector<AssessedFit>& tried,
                                     const std::vector<std::size_t>& members) {
  std::vector<std::size_t> smallest;
  for (const std::size_t i : members) {
    const EffectNames own = names_of(tried[i].fit.effects);
    const bool needs_not_all = std::any_of(members.begin(), members.end(), [&](std::size_t j) {
      const EffectNames other = names_of(tried[j].fit.effects);
      if (other == own && j != i)  // one of them has sizes of every ball
        return tried[j].information_criterion() < tried[i].information_criterion();
      return (other.size() < own.size() &&
              std::includes(own.begin(), own.end(), other.begin(), other.end())) ||
             frees_formulas_of(tried[i].fit, tried[j].fit);
    });
    if (!needs_not_all) smallest.push_back(i);
  }
  return smallest;
}

bool may_end_with(const std::vector<AssessedFit>& tried, const std::vector<std::size_t>& members,
                  std::size_t known) {
  return std::any_of(members.begin(), members.end(), [&](std::size_t i) {
    const AssessedFit& one = tried[i];
    return one.fit.effects.size() != known + 1 || !has_curve(one.fit) || !one.leaves_structure();
  });
}

const AssessedFit* leader_over_adequate(const std::vector<AssessedFit>& tried, double reach,
                                        double smallest_p) {
  const Criteria best = best_of(tried);
  const AssessedFit* leader = nullptr;
  for (const AssessedFit& one : tried)
    if (one.p_value > smallest_p && one.information_criterion() < best.information - reach &&
        one.prediction_criterion() < best.prediction &&
        (!leader || one.information_criterion() < leader->information_criterion()))
      leader = &one;
  return leader;
}

void prefer_nearly_adequate(std::vector<AssessedFit>& tried, std::size_t known, double reach,
                            std::vector<std::size_t>& members) {
  const double best = best_of(tried).information;
  const bool singles = std::all_of(members.begin(), members.end(), [&](std::size_t i) {
    return tried[i].fit.effects.size() == known + 1;
  });
  bool preferred = false;
  for (AssessedFit& one : tried) {
    if (one.adequate || !one.nearly_adequate || one.fit.effects.size() != known + 1) continue;
    const bool leads_singles = singles && !has_curve(one.fit) && one.information_criterion() < best;
    if (one.information_criterion() >= best - reach && !leads_singles) continue;
    one.adequate = preferred = true;
  }
  if (preferred) members = indistinguishable_models(tried, reach);
}

bool accept_leading_pair(std::vector<AssessedFit>& tried, std::size_t known, double reach,
                         std::vector<std::size_t>& members) {
  constexpr double plainly = 5.0;
  if (!members.empty() || tried.size() < 2) return false;
  AssessedFit& leader = tried.front();
  if (!leader.nearly_adequate || leader.fit.effects.size() != known + 2 || !has_curve(leader.fit) ||
      tried[1].information_criterion() < leader.information_criterion() + plainly * reach)
    return false;
  leader.adequate = true;
  members = {0};
  return true;
}

void deny_other_families_than_leader(const std::vector<AssessedFit>& tried, std::size_t known,
                                     double reach, double smallest_p,
                                     std::vector<std::size_t>& members) {
  const AssessedFit* leader = leader_over_adequate(tried, reach, smallest_p);
  if (!leader) return;
  const auto of_leader = families_beyond(leader->fit, known);
  std::erase_if(members, [&](std::size_t i) {
    const auto own = families_beyond(tried[i].fit, known);
    return std::none_of(own.begin(), own.end(),
                        [&](EffectFamily family) { return of_leader.contains(family); });
  });
}

void drop_many_numbers_behind_fewer(const std::vector<AssessedFit>& tried, double reach,
                                    double smallest_p, std::vector<std::size_t>& members) {
  double best = std::numeric_limits<double>::infinity();
  for (const AssessedFit& one : tried)
    if (one.p_value > smallest_p && !has_many_numbers(one.fit))
      best = std::min(best, one.information_criterion());
  std::erase_if(members, [&](std::size_t i) {
    return has_many_numbers(tried[i].fit) && best < tried[i].information_criterion() - reach;
  });
}

void keep_within_reach(const std::vector<AssessedFit>& tried, double reach,
                       std::vector<std::size_t>& members) {
  Criteria best;
  for (const std::size_t i : members) best.compare_with(tried[i]);
  std::erase_if(members, [&](std::size_t i) { return !within_reach(tried[i], best, reach); });
  std::stable_sort(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
    return tried[a].information_criterion() < tried[b].information_criterion();
  });
}

double gain_over(const AssessedFit& none, const AssessedFit& one) {
  const double gain = none.fit.information_criterion - one.fit.information_criterion;
  if (!none.unseen_chi_square || !one.unseen_chi_square) return gain;
  return gain + *none.unseen_chi_square - *one.unseen_chi_square;
}

void drop_what_gains_nothing(const std::vector<AssessedFit>& tried, const AssessedFit& none,
                             double reach, std::vector<std::size_t>& members) {
  const auto cost_of_numbers = [](const AssessedFit& of) {  // beyond 2 a number
    return of.fit.information_criterion - of.fit.prediction_criterion;
  };
  std::erase_if(members, [&](std::size_t i) {
    const double gain = gain_over(none, tried[i]);
    const double by_prediction = gain + cost_of_numbers(tried[i]) - cost_of_numbers(none);
    return std::max(gain, by_prediction) <= reach;
  });
}

}  // namespace rebound
