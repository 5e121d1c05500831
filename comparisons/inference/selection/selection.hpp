#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"

namespace rebound {

/// A law that stands for election.
struct Candidate {
  std::string label;
  LawRequest request;
};

/// How a candidate did at a speed it was not fitted to.
struct LeftOut {
  double speed = 0.0;   ///< [m/s]
  std::string failure;  ///< why there is no prediction; empty: there is
  /// Of force over time, over the peak force, mean square over shots; of scalars in standard
  /// deviations, where those were fitted.
  double force_rms = 0.0;
  double restitution_error = 0.0;   ///< predicted − reference
  double contact_time_error = 0.0;  ///< predicted/reference − 1
};

/// A candidate fitted to everything, and what speaks for it.
struct CandidateScore {
  std::string label;
  std::string failure;  ///< why it could not be fitted; empty: it was
  LawCalibration fitted;
  int parameters = 0;
  double misfit = 0.0;  ///< −2 ln of the likelihood at its best, up to a common constant
  double aicc = 0.0;
  double bic = 0.0;
  std::vector<LeftOut> left_out;           ///< one a speed; empty with a single speed
  std::optional<double> prediction_error;  ///< root mean square of force_rms; absent: a failure
};

struct Selection {
  std::vector<CandidateScore> candidates;  ///< in the order of the request
  double effective_data = 0.0;             ///< independent data that the correlated ones are worth
  std::vector<std::size_t> best_by_criterion;   ///< within 6 of the lowest BIC
  std::vector<std::size_t> best_by_prediction;  ///< not clearly worse than the best
  std::vector<std::size_t> chosen;  ///< one: a choice; several: they cannot be told apart
  std::string verdict;
  Observable observable = Observable::force_deflection;  ///< what was fitted and predicted
};

/// Ranks laws by information criteria and by prediction of a left-out speed.
///
///   χ² = Σ r² (noise known) or N ln(Σ r²/N) (unknown), both with N replaced by
///   the effective number N (1 − ρ)/(1 + ρ)
///   AICc = χ² + 2 M + 2 M (M+1)/(N − M − 1),   BIC = χ² + M ln N
///
///   M   free parameters      N   data      ρ   lag-one autocorrelation of the
///       residuals of the best-fitting candidate, so that all share one N
///
/// A candidate is clearly worse by prediction where its error is above 1.1 times
/// the best one's, in the mean and at every left-out speed. Chosen are those
/// that neither ranking excludes; where the rankings exclude each other's best,
/// all of both are, and nothing is told apart.
/// Valid:   candidates fitted to the same shots and the same observable.
/// Limit:   the law that made the data is chosen, alone or with those that
///          contain it -> test SelectionTest.FindsTheLawThatMadeTheData; noise
///          hides the difference -> test SelectionTest.SaysWhenNothingTells.
/// Caution: all candidates may be wrong; residual autocorrelation says so.
/// Errors:  Error(bad_input) for fewer than two candidates or no shots;
///          Error(interrupted).
Selection select_law(const std::vector<Candidate>& candidates,
                     const std::vector<MeasuredImpact>& references,
                     const LawCalibrationOptions& options = {}, const RunControl& control = {});

}  // namespace rebound
