#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/names.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What is known of an unknown beside the data: a normal distribution. It
/// enters as one more residual, (value − mean)/deviation.
struct Prior {
  double mean = 0.0;
  double deviation = 0.0;  ///< one standard deviation, > 0
};

/// One unknown of a calibration.
struct CalibrationParameter {
  std::string name;    ///< e.g. "stiffness"
  std::string unit;    ///< SI, for messages and reports, e.g. "N/m^1.5"
  double start = 0.0;  ///< first guess, within the bounds
  double lowest = 0.0;
  double highest = 0.0;
  double scale = 1.0;            ///< typical size; sets steps and the meaning of "small"
  std::optional<Prior> prior{};  ///< needs data whose noise is known
};

/// Residuals at a parameter vector (in the order of the parameters):
/// (model − data)/σ, one per datum, always the same number. Any tier may stand
/// behind it. It may throw Error(solver_failed) where the model has no answer;
/// the search then keeps away from there. Other errors end the calibration.
using ResidualFunction = std::function<std::vector<double>(const std::vector<double>&)>;

/// Residuals with their derivatives by the parameters.
struct ResidualsWithJacobian {
  std::vector<double> residuals;
  std::vector<double> slopes;  ///< ∂r/∂x, one row a residual
};
using JacobianFunction = std::function<ResidualsWithJacobian(const std::vector<double>&)>;

/// Residuals that fall into parts, as those of the shots of an experiment: a part has unknowns that
/// move no row of another, such as the start of its record. Derivatives by them are then taken of
/// the part alone, and a step is solved part by part. The rows of all parts, one after the other,
/// are those of CalibrationProblem::residuals.
struct ResidualParts {
  struct Part {
    std::size_t rows = 0;
    std::vector<std::size_t> own;  ///< its unknowns; those of no part are shared by all
  };
  std::vector<Part> parts;
  /// Rows of one part at a parameter vector. It may throw as ResidualFunction does.
  std::function<std::vector<double>(const std::vector<double>& x, std::size_t part)> residuals;
};

/// What σ in the residuals means.
enum class NoiseKnowledge {
  known,      ///< σ are the data's standard deviations: intervals follow from them
  estimated,  ///< σ are weights only: the residual variance at the optimum sets the intervals
};

/// Loss of one residual r, so that single wrong data do not decide:
///
///   none      r²
///   huber     r² up to the scale a, 2 a |r| − a² beyond
///   soft_l1   2 a² (√(1 + (r/a)²) − 1)
///   cauchy    a² ln(1 + (r/a)²)
enum class RobustLoss { none, huber, soft_l1, cauchy };
constexpr auto names_of(RobustLoss) {
  return names_list<RobustLoss>({{"squares", RobustLoss::none},
                                 {"huber", RobustLoss::huber},
                                 {"soft-l1", RobustLoss::soft_l1},
                                 {"cauchy", RobustLoss::cauchy}});
}

/// Are likelihood-ratio intervals computed beside the linearised ones?
enum class Profiles { skipped, each_parameter };
constexpr auto names_of(Profiles) {
  return names_list<Profiles>({{"none", Profiles::skipped}, {"all", Profiles::each_parameter}});
}

/// Differences of a model without derivatives of its own: to both sides, or, at half the price and
/// with an error of the first order in the step, to one.
enum class Differences { central, one_sided };

struct CalibrationControls {
  /// Differences are taken at this times the parameter's scale. The default
  /// suits models that are smooth to 1e-9; a model with discretisation ripple
  /// wants 1e-2 or so.
  double relative_step = 1e-4;
  Differences differences = Differences::central;
  /// A run costs so much that a search is to come by with few: its first steps are short, and a
  /// step that gains nothing is made shorter rather than searched along.
  bool runs_are_dear = false;
  /// The search ends when an iteration changes the cost by less than this
  /// share, or is below its square times the first one. A model with
  /// discretisation ripple wants 1e-3 or so.
  double cost_tolerance = 1e-12;
  int iterations = 100;  ///< most, per start
  int starts = 1;        ///< the given start, then seeded ones within the bounds
  std::uint64_t seed = 1;
  double confidence = 0.95;  ///< of the intervals
  RobustLoss loss = RobustLoss::none;
  /// a in standard deviations of the noise; where that is unknown, 1.4826
  /// times the median absolute residual stands for it.
  double loss_scale = 2.0;
  Profiles profiles = Profiles::skipped;
  /// Where evaluations are kept, so that a killed calibration goes on where it
  /// was; empty: nowhere. See evaluation_cache.hpp.
  std::filesystem::path checkpoint{};
};

/// A whole calibration: unknowns, residuals, and what is known of the noise.
struct CalibrationProblem {
  std::vector<CalibrationParameter> parameters;
  ResidualFunction residuals;
  /// Where the model knows its derivatives; empty: they are differences.
  JacobianFunction with_jacobian{};
  /// Where the residuals fall into parts, for a search without robust loss, profiles and
  /// checkpoint; empty: every unknown moves every row.
  std::optional<ResidualParts> parts{};
  NoiseKnowledge noise = NoiseKnowledge::estimated;
  CalibrationControls controls;
};

enum class Identifiability {
  identified,
  weakly_identified,  ///< determined, but not well enough to be used alone
  at_bound,           ///< the optimum lies on a bound: the data want to go beyond
  not_identifiable,   ///< the data do not determine it
};
constexpr auto names_of(Identifiability) {
  return names_list<Identifiability>({{"identified", Identifiability::identified},
                                      {"weakly-identified", Identifiability::weakly_identified},
                                      {"at-bound", Identifiability::at_bound},
                                      {"not-identifiable", Identifiability::not_identifiable}});
}

/// Values of one parameter that the data do not contradict, the others
/// refitted at each: 2 ΔC/s² at most the χ² (or F) quantile, C = ½ Σ r².
struct ProfileInterval {
  double low = 0.0, high = 0.0;
  bool low_closed = false;  ///< false: the bound of the search came first
  bool high_closed = false;
  std::vector<double> value;  ///< points of the profile, ascending
  std::vector<double> cost;   ///< C at them
};

/// One estimated parameter.
struct Estimate {
  std::string name;
  std::string unit;
  double value = 0.0;
  double standard_error = 0.0;   ///< infinite when not identifiable
  double low = 0.0, high = 0.0;  ///< confidence interval, cut at the bounds
  Identifiability identifiability = Identifiability::identified;
  std::string verdict;                       ///< in words
  std::optional<ProfileInterval> profile{};  ///< where asked for
};

struct CalibrationResult {
  std::vector<Estimate> estimates;
  std::vector<std::vector<double>>
      correlation;                  ///< between parameters; empty if one is not identifiable
  double cost_before = 0.0;         ///< ½ Σ r² at the given start
  double cost_after = 0.0;          ///< ½ Σ r² at the estimates
  double reduced_chi_square = 0.0;  ///< Σ r²/(data − parameters); 1 is the noise, if σ is known
  double residual_autocorrelation = 0.0;  ///< lag one; near 0 for noise, near 1 for model error
  int data = 0;
  int evaluations = 0;  ///< of the residual function
  bool converged = false;
  NoiseKnowledge noise = NoiseKnowledge::estimated;
  std::vector<std::string> warnings;
  std::string verdict;  ///< one sentence on the whole fit

  /// Of the estimates, in their order.
  std::vector<double> values() const {
    std::vector<double> all;
    for (const Estimate& one : estimates) all.push_back(one.value);
    return all;
  }
};

/// Weighted least squares, min ½ Σ r², within the bounds, by Ceres'
/// Levenberg–Marquardt method, with the model's own derivatives or differences.
///
///   standard errors   √diag[s² (JᵀJ)⁻¹],  s² = 1 or Σ r²/(N − M)
///   intervals         normal, or Student's t with N − M degrees of freedom
///
/// Valid:   independent errors of the stated sizes; intervals by linearisation.
/// Limit:   coverage of the intervals under seeded noise, counted
///          -> test LawCalibrationTest.IntervalsCoverTheTruth.
///          Likelihood-ratio intervals of a linear problem equal the linearised
///          -> test ProfileTest.EqualsLinearisedWhereTheModelIsLinear.
/// Caution: where the model is wrong, residuals are correlated and the
///          intervals too narrow; a warning says so.
/// Errors:  Error(bad_input) for no parameters, start outside the bounds, fewer
///          data than parameters, not-finite residuals at the start, a prior
///          while the noise is unknown; Error(corrupt_store) for a damaged
///          checkpoint; Error(interrupted) when asked to stop; what the residual
///          function throws at the start.
CalibrationResult calibrate(const CalibrationProblem& problem, const RunControl& control = {});

}  // namespace rebound
