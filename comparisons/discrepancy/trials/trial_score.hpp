#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_run.hpp"
#include "comparisons/discrepancy/trials/trial_truth.hpp"

namespace rebound {

/// So many of so many, with the 95 % interval of the share.
///
///   (p + z²/2n ± z √(p(1 − p)/n + z²/4n²)) / (1 + z²/n),  z = 1.96
///
/// Source: Wilson 1927, J. Am. Stat. Assoc. 22, 209.
struct Share {
  int count = 0, of = 0;

  double value() const { return of == 0 ? 0.0 : static_cast<double>(count) / of; }
  double low() const;
  double high() const;
};

/// A share and what is asked of it.
struct TrialGate {
  std::string what;
  Share share;
  double least = 0.0, most = 1.0;    ///< of the share
  double most_of_upper_bound = 1.0;  ///< of the upper end of its interval

  /// Is anything asked of it, or is it there to be read?
  bool is_asked() const { return least > 0.0 || most < 1.0 || most_of_upper_bound < 1.0; }
  bool passes() const;
};

struct TrialScores {
  std::vector<TrialGate> gates;
  /// Verdicts by what was hidden: family of the truth, then what was said of it.
  std::map<std::string, std::map<std::string, int>> confusion;
  std::map<std::string, Share> false_alarms_by_noise;
  /// Family right or left open with it in the set, by the form that was hidden.
  std::map<std::string, Share> not_wrong_by_form;
  double median_seconds = 0.0, longest_seconds = 0.0;
  int trials = 0;
};

/// Scores outcomes against truths, trial by trial.
///
/// Counted are nulls, and effects that show (visible χ² of 25 or more).
///   family right   the verdict's family, or a fault of the measurement, is that of the truth
///   name right     the nearest effect of the list is the one named
///   in the set     it stands in a candidate
///   wrong name     one effect is named, and it is another
///   unseen gap     where it is above three deviations of its noise, four fifths of it are gone
/// Errors: Error(corrupt_store) where trials and truths are not the same.
TrialScores score_trials(const std::vector<TrialOutcome>& outcomes,
                         const std::vector<TrialTruth>& truths);

}  // namespace rebound
