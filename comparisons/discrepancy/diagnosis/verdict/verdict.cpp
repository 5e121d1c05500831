#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/candidate_family.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/shots_that_differ.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

/// Families of what a fit adds to the believed model, as they act in it.
FamilySet added_families(const Diagnosis& d, const HypothesisFit& fit) {
  FamilySet families;
  for (std::size_t k = d.believed_effects; k < fit.effects.size(); ++k)
    families.push_back(acting_family(*d.seen, fit, k));
  return families;
}

/// What each fit of the search explains by itself, over what the best does.
std::vector<ExplainedShare> explained_shares(const Diagnosis& d, const HypothesisFit& best) {
  const double before = d.selection.baseline.fit.chi_square;
  const double explained = before - best.chi_square;
  if (!(explained > 0.0)) return {};  // the baseline itself fits best
  std::vector<ExplainedShare> shares;
  for (const AssessedFit& one : d.selection.tried)
    shares.push_back({added_effects(one.fit, d.believed_effects), added_families(d, one.fit),
                      (before - one.fit.chi_square) / explained});
  return shares;
}

/// What candidates add to the believed model, with numbers and intervals, measured once each.
class Additions {
 public:
  explicit Additions(const Diagnosis& d) : d_(d) {}

  /// Measures several at once.
  void measure(const std::vector<const HypothesisFit*>& fits) {
    std::vector<std::vector<NamedEffect>> all(fits.size());
    in_parallel(fits.size(), [&](std::size_t i) { all[i] = measured(*fits[i]); });
    for (std::size_t i = 0; i < fits.size(); ++i) known_[fits[i]] = std::move(all[i]);
  }
  const std::vector<NamedEffect>& of(const HypothesisFit& fit) {
    if (!known_.contains(&fit)) known_[&fit] = measured(fit);
    return known_.at(&fit);
  }

 private:
  std::vector<NamedEffect> measured(const HypothesisFit& fit) const {
    return named_effects(fit, d_.believed_effects);
  }
  const Diagnosis& d_;
  std::map<const HypothesisFit*, std::vector<NamedEffect>> known_;
};

/// Why a single candidate carries no name; empty where it does.
std::string why_no_name(const std::vector<NamedEffect>& effects, const FamilySet& acting) {
  for (const NamedEffect& one : effects)
    if (find_effect(one.effect.name).card.is_free_form)
      return "no formula of the list does as well as a free curve";
  for (std::size_t k = 0; k < effects.size(); ++k)
    if (acting[k] != find_effect(effects[k].effect.name).card.family)
      return fmt::format("{} fades so fast that any damper may stand for it",
                         effects[k].effect.name);
  for (const NamedEffect& one : effects)
    if (!one.weak.empty()) return fmt::format("{}: {}", one.effect.name, one.weak);
  return {};
}

bool best_candidate_is_nearly_adequate(const Diagnosis& d) {
  const auto& candidates = d.selection.indistinguishable;
  return !candidates.empty() && d.selection.tried[candidates.front()].nearly_adequate;
}

bool are_of_three_and_more(const std::vector<std::vector<std::string>>& candidates) {
  return std::all_of(candidates.begin(), candidates.end(),
                     [](const auto& names) { return names.size() >= 3; });
}

void conclude_from_candidates(Diagnosis& d, const SelectionRules& rules, Additions& additions) {
  std::vector<const HypothesisFit*> fits;
  for (const std::size_t i : d.selection.indistinguishable)
    fits.push_back(&d.selection.tried[i].fit);
  if (fits.empty()) fits.push_back(&d.selection.baseline.fit);  // set right by its formula alone
  std::vector<FamilySet> families;
  for (const auto* fit : fits) {
    d.candidates.push_back(added_effects(*fit, d.believed_effects));
    families.push_back(added_families(d, *fit));
  }
  d.family = common_family(families);
  if (d.family == EffectFamily::none)
    d.family = main_family(families, explained_shares(d, *fits.front()));
  const auto in_all = [&](const std::string& name) {
    return std::all_of(d.candidates.begin(), d.candidates.end(), [&](const auto& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
  };
  const bool only_measurement = std::all_of(
      d.candidates.begin(), d.candidates.end(),
      [](const auto& names) { return std::all_of(names.begin(), names.end(), is_measurement); });
  const std::vector<std::string>& first = d.candidates.front();
  if (std::any_of(first.begin(), first.end(), in_all)) {
    const std::vector<NamedEffect>& effects = additions.of(*fits.front());
    if (fits.size() == 1) d.withheld = why_no_name(effects, families.front());
    if (fits.size() == 1 && d.withheld.empty() && best_candidate_is_nearly_adequate(d))
      d.withheld = fmt::format(
          "{} explains most of what is missing and fits plainly better than all else, yet "
          "something beyond the noise is left beside it",
          label_of(fits.front()->effects));
    if (d.withheld.empty())
      std::copy_if(effects.begin(), effects.end(), std::back_inserter(d.effects),
                   [&](const NamedEffect& one) { return in_all(one.effect.name); });
  }
  if (fits.size() == 1)
    for (std::size_t k = d.believed_effects; k < fits.front()->effects.size(); ++k)
      for (FactorBand& band : bands_of(*fits.front(), k)) d.curves.push_back(std::move(band));
  if (only_measurement) {
    d.verdict = DiagnosisVerdict::measurement_fault;
    for (const auto* fit : fits)
      d.fault += (d.fault.empty() ? "" : " or ") + label_of(fit->effects);
  } else if (fits.size() > 1 && are_of_three_and_more(d.candidates)) {
    withhold(d, DiagnosisVerdict::unexplained,
             "several sets of three effects and more follow the data alike, as they would follow "
             "anything");
  } else if (fits.size() > 1) {
    d.verdict = DiagnosisVerdict::one_of;
  } else if (d.withheld.empty()) {
    d.verdict = DiagnosisVerdict::missing;
  } else {
    d.verdict = without_name(d);
  }
  if (fits.size() > 1) d.next = next_experiments(*d.seen, fits, rules.close_criterion);
}

/// Data that are left to contradict a fit: less what was fitted, and less the
/// restitutions that a damping formula was given.
int contradicting_data(const Observations& seen, const HypothesisFit& fit) {
  int inputs = 0;
  if (!fit.hypothesis.believed.damping_formula.empty())
    for (const MeasuredImpact& shot : seen.shots) inputs += shot.restitution.value ? 1 : 0;
  const auto priors = static_cast<int>(fit.residuals.size() - fit.data_rows());
  return static_cast<int>(fit.data_rows()) - inputs -
         (static_cast<int>(fit.values.size()) - priors);
}

/// Of several candidates, a set in which one member may as well not be there explains nothing by
/// itself: it leaves the list while others stay.
void drop_sets_with_idle_members(Diagnosis& d, Additions& additions) {
  auto& candidates = d.selection.indistinguishable;
  if (candidates.size() < 2) return;
  std::vector<const HypothesisFit*> sets;
  for (const std::size_t i : candidates)
    if (const HypothesisFit& fit = d.selection.tried[i].fit;
        added_effects(fit, d.believed_effects).size() > 1)
      sets.push_back(&fit);
  additions.measure(sets);
  const auto idle = [&](std::size_t i) {
    const HypothesisFit& fit = d.selection.tried[i].fit;
    return std::find(sets.begin(), sets.end(), &fit) != sets.end() &&
           !why_no_name(additions.of(fit), added_families(d, fit)).empty();
  };
  if (std::all_of(candidates.begin(), candidates.end(), idle)) return;
  std::erase_if(candidates, idle);
}

/// Sets that fit because nothing was left to contradict them are no candidates. Where all are
/// of that kind, the data are not enough, whatever their number.
void withdraw_what_cannot_fail(Diagnosis& d, const SelectionRules& rules) {
  auto& candidates = d.selection.indistinguishable;
  std::vector<const HypothesisFit*> withdrawn;
  std::string labels;
  const auto cannot_fail = [&](std::size_t i) {
    const HypothesisFit& fit = d.selection.tried[i].fit;
    if (contradicting_data(*d.seen, fit) > 0) return false;
    withdrawn.push_back(&fit);
    labels += (labels.empty() ? "" : " or ") + label_of(fit.effects);
    return true;
  };
  std::erase_if(candidates, cannot_fail);
  if (withdrawn.empty() || !candidates.empty()) return;
  d.needed.push_back(
      fmt::format("data that could contradict it: {} would fit what is left, but with as many "
                  "numbers as there are data; force histories, or further speeds",
                  labels));
  if (withdrawn.size() > 1) d.next = next_experiments(*d.seen, withdrawn, rules.close_criterion);
}

void locate(Diagnosis& d) {
  const ResidualMap& map = d.believed.map;
  for (const MapCell& cell : map.cells)
    if (std::abs(cell.z) > map.threshold) d.where.push_back(cell);
  std::stable_sort(d.where.begin(), d.where.end(), [](const MapCell& a, const MapCell& b) {
    return std::abs(a.z) > std::abs(b.z);
  });
}

}  // namespace

void conclude(Diagnosis& d, const SelectionRules& rules) {
  withdraw_what_cannot_fail(d, rules);
  prefer_a_ball_that_stays(d);
  Additions additions(d);
  drop_sets_with_idle_members(d, additions);
  locate(d);
  if (!d.selection.explains()) {
    d.verdict =
        d.needed.empty() ? DiagnosisVerdict::unexplained : DiagnosisVerdict::insufficient_data;
    d.effects = additions.of(d.best());
  } else if (d.extended()) {
    conclude_from_candidates(d, rules, additions);
    if (d.verdict == DiagnosisVerdict::missing && speed_clusters(*d.seen).size() < 2)
      withhold(d, without_name(d),
               "all shots have one speed, so that nothing is seen to hold at another");
  } else {
    d.verdict = DiagnosisVerdict::agrees;
    d.excluded = d.selection.excluded;
  }
}

std::vector<FamilySet> families_of_candidates(const Diagnosis& d) {
  const std::vector<std::size_t>& members = d.selection.indistinguishable;
  std::vector<FamilySet> all;
  for (std::size_t i = 0; i < d.candidates.size(); ++i) {
    const HypothesisFit* fit = i < members.size() ? &d.selection.tried[members[i]].fit : nullptr;
    if (fit && added_effects(*fit, d.believed_effects) == d.candidates[i]) {
      all.push_back(added_families(d, *fit));
      continue;
    }
    FamilySet& families = all.emplace_back();  // of FE, or of the measurement
    for (const std::string& name : d.candidates[i])
      families.push_back(find_effect(name).card.family);
  }
  return all;
}

void find_nearest_formulas(Diagnosis& d) {
  if (d.verdict == DiagnosisVerdict::family)
    d.nearest = nearest_formulas(d.family, explained_shares(d, d.best()));
}

}  // namespace rebound
