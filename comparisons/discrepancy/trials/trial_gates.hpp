#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_share.hpp"

/// What is asked of a diagnosis over many trials.
namespace rebound {

/// What so many trials say of a gate.
enum class GateAnswer {
  not_asked,  ///< the share is there to be read
  no_trial,
  too_few,  ///< no count of so many trials would meet it, and the share is not clearly off it
  met,
  missed
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

  /// Three trials cannot lie between 90 and 98 %, nor can no alarm of 29 nulls be below 7.5 % with
  /// its upper bound: that is no miss, unless the whole interval of the share is off what is asked.
  ///
  /// Limit: with trials enough it is met or missed -> test TrialGatesTest.TooFewTrials.
  GateAnswer answer() const;
};

/// The shares behind the gates.
struct TrialCounts {
  Share false_alarm, false_alarm_misstated, detected, family_right, family_right_where_said,
      wrong_family, abstained, name_right, formula_right, name_or_nearest, wrong_name;
  Share separable_family_right, separable_name_right;
  Share single_name_right;  ///< of those that say one
  Share out_of_family_said, visibly_out_of_family_said, out_of_family_named, unseen_better,
      coverage, pairs_both, visible_pairs_both, pairs_both_families, pairs_not_false;
};

/// The shares against what is asked of them, in the order in which they are read.
std::vector<TrialGate> gates_of(const TrialCounts& counts);

/// Those of balls in finite elements, single effects alone.
std::vector<TrialGate> gates_in_fem_of(const TrialCounts& counts);

}  // namespace rebound
