#include "comparisons/discrepancy/diagnosis/search/unseen_choice.hpp"

#include <algorithm>
#include <limits>

#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Infinite where the model has no impact at that speed.
double chi_square_unseen(const Observations& unseen, const HypothesisFit& fit) {
  try {
    return predict_unseen(unseen, fit).chi_square;
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace

bool is_plain_gap(double reduced_chi_square, double deviation) {
  constexpr double plain = 0.5, noise_deviations = 6.0;
  return reduced_chi_square - 1.0 > std::max(plain, noise_deviations * deviation);
}

std::optional<std::size_t> odd_one_of(const std::vector<ShotGap>& gaps) {
  std::optional<std::size_t> odd;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!is_plain_gap(gaps[i].reduced_chi_square, gaps[i].deviation())) continue;
    if (odd) return std::nullopt;
    odd = i;
  }
  return gaps.size() > 1 ? odd : std::nullopt;
}

bool leaves_a_gap_in(const Observations& all, const HypothesisFit& fit,
                     const std::vector<std::string>& effects, const SelectionRules& rules,
                     std::uint64_t seed) {
  AssessedFit whole = judge_by_chi_square(all, fit_further(all, fit), rules);
  if (whole.judged) return true;
  const EffectSensitivities around(all, whole.fit, effects);
  look_closely(all, around, rules, rules.false_gap_level, seed, whole);
  return !whole.adequate;
}

void choose_with_unseen_speed(const Observations& unseen, const SelectionRules& rules,
                              EffectSelection& selection) {
  std::vector<AssessedFit*> predicting{&selection.baseline};
  for (const std::size_t i : selection.indistinguishable) predicting.push_back(&selection.tried[i]);
  in_parallel(predicting.size(), [&](std::size_t k) {
    predicting[k]->unseen_chi_square = chi_square_unseen(unseen, predicting[k]->fit);
  });
  keep_within_reach(selection.tried, rules.close_criterion, selection.indistinguishable);
  for (AssessedFit* one : predicting) one->unseen_denies = one != &selection.baseline;
  for (const std::size_t i : selection.indistinguishable) selection.tried[i].unseen_denies = false;
}

}  // namespace rebound
