#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lumped/problem/run_control.hpp"

namespace rebound {

/// One unknown of a calibration.
struct CalibrationParameter {
  std::string name;      ///< e.g. "stiffness"
  std::string unit;      ///< SI, for messages and reports, e.g. "N/m^1.5"
  double start = 0.0;    ///< first guess, within the bounds
  double lowest = 0.0;
  double highest = 0.0;
  double scale = 1.0;    ///< typical size; sets steps and the meaning of "small"
};

/// Residuals at a parameter vector (in the order of the parameters):
/// (model − data)/σ, one per datum, always the same number. Any tier may stand
/// behind it. It may throw Error(solver_failed) where the model has no answer;
/// the search then keeps away from there. Other errors end the calibration.
using ResidualFunction = std::function<std::vector<double>(const std::vector<double>&)>;

/// What σ in the residuals means.
enum class NoiseKnowledge {
  known,      ///< σ are the data's standard deviations: intervals follow from them
  estimated,  ///< σ are weights only: the residual variance at the optimum sets the intervals
};

struct CalibrationControls {
  /// Differences are taken at this times the parameter's scale. The default
  /// suits models that are smooth to 1e-9; a model with discretisation ripple
  /// wants 1e-2 or so.
  double relative_step = 1e-4;
  /// The search ends when an iteration changes the cost by less than this
  /// share. A model with discretisation ripple wants 1e-3 or so.
  double cost_tolerance = 1e-12;
  int iterations = 100;     ///< most, per start
  int starts = 1;           ///< the given start, then seeded ones within the bounds
  std::uint64_t seed = 1;
  double confidence = 0.95; ///< of the intervals
};

/// A whole calibration: unknowns, residuals, and what is known of the noise.
struct CalibrationProblem {
  std::vector<CalibrationParameter> parameters;
  ResidualFunction residuals;
  NoiseKnowledge noise = NoiseKnowledge::estimated;
  CalibrationControls controls;
};

enum class Identifiability {
  identified,
  at_bound,          ///< the optimum lies on a bound: the data want to go beyond
  not_identifiable,  ///< the data do not determine it
};

/// One estimated parameter.
struct Estimate {
  std::string name;
  std::string unit;
  double value = 0.0;
  double standard_error = 0.0;  ///< infinite when not identifiable
  double low = 0.0, high = 0.0; ///< confidence interval, cut at the bounds
  Identifiability identifiability = Identifiability::identified;
  std::string verdict;          ///< in words
};

struct CalibrationResult {
  std::vector<Estimate> estimates;
  std::vector<std::vector<double>> correlation;  ///< between parameters; empty if one is not identifiable
  double cost_before = 0.0;            ///< ½ Σ r² at the given start
  double cost_after = 0.0;             ///< ½ Σ r² at the estimates
  double reduced_chi_square = 0.0;     ///< Σ r²/(data − parameters); 1 is the noise, if σ is known
  double residual_autocorrelation = 0.0;  ///< lag one; near 0 for noise, near 1 for model error
  int data = 0;
  int evaluations = 0;                 ///< of the residual function
  bool converged = false;
  NoiseKnowledge noise = NoiseKnowledge::estimated;
  std::vector<std::string> warnings;
  std::string verdict;                 ///< one sentence on the whole fit
};

/// Weighted least squares, min ½ Σ r², within the bounds, by Ceres'
/// Levenberg–Marquardt method with differenced derivatives.
///
///   standard errors   √diag[s² (JᵀJ)⁻¹],  s² = 1 or Σ r²/(N − M)
///   intervals         normal, or Student's t with N − M degrees of freedom
///
/// Valid:   independent errors of the stated sizes; intervals by linearisation.
/// Limit:   coverage of the intervals under seeded noise, counted
///          -> test LawCalibrationTest.IntervalsCoverTheTruth.
/// Caution: where the model is wrong, residuals are correlated and the
///          intervals too narrow; a warning says so.
/// Errors:  Error(bad_input) for no parameters, start outside the bounds, fewer
///          data than parameters, not-finite residuals at the start; what the
///          residual function throws at the start.
CalibrationResult calibrate(const CalibrationProblem& problem, const RunControl& control = {});

}  // namespace rebound
