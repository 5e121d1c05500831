#include "comparisons/discrepancy/diagnosis/next_experiment/next_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/discrepancy/diagnosis/next_experiment/separation.hpp"
#include "comparisons/inference/calibration/distributions.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Nothing where an impact has no answer: then there is no such experiment.
template <class Work>
auto unless_unsolved(const Work& work) -> std::optional<decltype(work())> {
  try {
    return work();
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
    return std::nullopt;
  }
}

/// A believed FE model is run for impacts only.
bool is_slow(const PlannedExperiment& planned) {
  return std::any_of(planned.records.begin(), planned.records.end(), [](const PlannedRecord& one) {
    return one.quantity == RecordedQuantity::slow_force;
  });
}

}  // namespace

std::string label_of(const std::vector<EffectChoice>& effects) {
  std::string label;
  for (const auto& effect : effects) label += (label.empty() ? "" : " + ") + effect.name;
  return label.empty() ? "nothing" : label;
}

double chance_that_truth_wins(const Observations& seen, const HeldFit& truth, const HeldFit& rival,
                              const PlannedExperiment& experiment, double close_criterion) {
  const double gained = expected_separation(seen, truth, rival, experiment);
  const double lead = rival.fit->information_criterion - truth.fit->information_criterion;
  return normal_chance_below((gained + lead - close_criterion) / (2.0 * std::sqrt(gained) + 1e-12));
}

std::vector<NextExperiment> next_experiments(const Observations& seen,
                                             const std::vector<const HypothesisFit*>& candidates,
                                             double close_criterion) {
  std::vector<HeldFit> held;
  for (const HypothesisFit* one : candidates)
    if (auto found = unless_unsolved([&] { return held_by_the_data(*one); }))
      held.push_back(std::move(*found));
  std::vector<NextExperiment> experiments;
  std::vector<PlannedExperiment> possible = possible_experiments(seen);
  if (candidates.front()->model->fem()) std::erase_if(possible, is_slow);
  for (const PlannedExperiment& planned : possible)
    for (std::size_t i = 0; i < held.size(); ++i)
      for (std::size_t j = i + 1; j < held.size(); ++j) {
        const auto chance = unless_unsolved([&] {
          return std::min(chance_that_truth_wins(seen, held[i], held[j], planned, close_criterion),
                          chance_that_truth_wins(seen, held[j], held[i], planned, close_criterion));
        });
        if (chance)
          experiments.push_back(
              {.what = planned.what,
               .separates = {label_of(held[i].fit->effects), label_of(held[j].fit->effects)},
               .probability = *chance});
      }
  std::stable_sort(experiments.begin(), experiments.end(),
                   [](const NextExperiment& a, const NextExperiment& b) {
                     return a.probability > b.probability;
                   });
  constexpr double worth_it = 0.1;
  std::erase_if(experiments, [](const NextExperiment& e) { return e.probability < worth_it; });
  // One line a pair and one more for an alternative is what a reader uses.
  constexpr std::size_t most = 6;
  if (experiments.size() > most) experiments.resize(most);
  return experiments;
}

}  // namespace rebound
