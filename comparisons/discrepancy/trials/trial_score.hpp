#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_gates.hpp"
#include "comparisons/discrepancy/trials/trial_rates.hpp"
#include "comparisons/discrepancy/trials/trial_run.hpp"

namespace rebound {

/// Counts by what was hidden, then by what was said of it.
using ConfusionMatrix = std::map<std::string, std::map<std::string, int>>;

struct TrialScores {
  std::vector<TrialGate> gates;
  /// Gates of each control in the same order, by the same rules; nothing where a control has no
  /// such quantity.
  std::map<std::string, std::vector<TrialGate>> controls;
  ConfusionMatrix confusion;          ///< by family
  ConfusionMatrix confusion_by_name;  ///< nearest effect of the list against the name that was said
  std::map<std::string, Share> false_alarms_by_noise;
  /// Family right or left open with it in the set, by the form that was hidden.
  std::map<std::string, Share> not_wrong_by_form;
  std::vector<RateTable> rates;  ///< power over size, noise and number of speeds
  double mean_candidates = 0.0;  ///< sets of effects where any is said
  double median_seconds = 0.0, longest_seconds = 0.0;
  int trials = 0;
  int not_visible = 0;                                ///< effects that do not count
  int without_answer = 0;                             ///< diagnoses that ended in an error
  std::map<std::string, int> origins;                 ///< trials by set and seed of the generator
  TrialProtocols protocols;                           ///< more than one: not one error rate
  std::map<std::string, Share> false_alarms_by_ball;  ///< of balls in finite elements
  /// Of balls in finite elements, apart from all others; null where there are none.
  std::shared_ptr<const TrialScores> in_fem;
  /// Of those of them whose believed model is in finite elements, too; apart from `in_fem`.
  std::shared_ptr<const TrialScores> fem_believed;
};

/// Scores outcomes against truths, trial by trial.
///
/// Counted are nulls, and effects that show (visible χ² of 25 or more). A diagnosis without an
/// answer is no false alarm and no silence: a null is left out, an effect counts as not found.
///   family right   the verdict's family, or a fault of the measurement, is that of the truth
///   name right     the nearest effect of the list is the one named
///   in the set     it stands in a candidate
///   wrong name     one effect is named, and it is another
///   abstained      a gap, but no family; or no gap, though the effect shows
///   in FE          trials of balls in finite elements are scored by themselves, and those in which
///                  such a ball is believed, too, again by themselves
///   unseen gap     where it is above three deviations of its noise, four fifths of it are gone
TrialScores score_trials(const TrialCollection& trials);

}  // namespace rebound
