#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/observations/measured_design.hpp"
#include "comparisons/discrepancy/trials/trial_run.hpp"
#include "comparisons/discrepancy/trials/trial_share.hpp"

/// How often a verdict like this one was right.
namespace rebound {

/// What blind trials of experiments like one came to. Effects count where they show: with a visible
/// χ² of 25 or more.
struct ErrorRates {
  bool in_fem = false;       ///< balls in finite elements; else balls that obey a law of a point
  int trials = 0;            ///< of such experiments
  double noise_share = 0.0;  ///< of all these trials; 0: it differs [-]
  int fewest_speeds = 0, most_speeds = 0;
  Share false_alarm;   ///< a gap was said, of those in which nothing was hidden
  Share effect_seen;   ///< a gap was said, of those in which an effect shows
  Share verdict_true;  ///< of those with the same verdict
  std::string true_means;
};

/// Of the trials, those of experiments like one: of the noise nearest by its ratio, and with two or
/// three speeds or with four and more, as it has. Trials of balls in finite elements are few, and
/// are taken together. Empty where the experiment has no force records: no trial is like it.
///
///   verdict             is true where
///   agrees              no effect shows
///   missing             the effect that is named was hidden, in this form or another; of several
///                       names, all were
///   family              the hidden effect is of that family
///   one-of              the hidden effect is one of the set
///   measurement-fault   a fault of the measurement was hidden
///   unexplained         something was hidden
///
/// Limit: trials are of the version of the program that they were run with, and their effects of
///        the sizes that were drawn; a share of true verdicts is one among such trials.
/// Test: ErrorRatesTest.CountsAreThoseOfTheStoredTrials.
std::vector<ErrorRates> error_rates_of(const MeasuredDesign& design, const std::string& verdict,
                                       const std::vector<TrialRecord>& trials);

/// The same of the trials that are kept with the program.
std::vector<ErrorRates> error_rates_of(const MeasuredDesign& design, const std::string& verdict);

}  // namespace rebound
