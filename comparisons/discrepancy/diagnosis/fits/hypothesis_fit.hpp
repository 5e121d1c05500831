#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A hypothesis fitted to all shots at once, and what is left over.
struct HypothesisFit {
  Hypothesis hypothesis;  ///< as it was started
  std::shared_ptr<const JointModel> model;
  std::vector<double> values;     ///< of the unknowns, at the optimum
  std::vector<double> residuals;  ///< data rows, then priors
  CalibrationResult search;
  std::vector<EffectChoice> effects;  ///< with fitted numbers
  double chi_square = 0.0;            ///< Σ r² over data and priors
  double data_chi_square = 0.0;       ///< Σ r² over the data alone
  int freedom = 0;                    ///< data − unknowns without a prior
  /// k: fitted numbers of effects (`curve_numbers`). One that a prior holds counts by the share
  /// that the data tell: a curve through eleven points is no eleven numbers where it is smooth.
  double effect_unknowns = 0.0;
  /// χ² + k ln N, N the independent data; curves as smooth as is best for it, what that loses in χ²
  /// counted.
  double information_criterion = 0.0;
  /// χ² + 2 k in the same way, and ln N in place of 2 for each frequency of an effect that swings:
  /// it was picked from as many as the records can tell apart, and of many some fits noise
  /// (look-elsewhere effect).
  double prediction_criterion = 0.0;

  /// k ln N of all numbers as they stand: a refit to other data bends curves by all of them.
  double penalty_of_refits = 0.0;

  std::size_t data_rows() const { return model->rows().size(); }
  double reduced_chi_square() const { return data_chi_square / freedom; }
};

/// Names of the effects that a fit has beyond the first `known`.
std::vector<std::string> added_effects(const HypothesisFit& fit, std::size_t known);

/// Values of a model's unknowns: as fitted for those of the same name, as the
/// model starts for all others.
std::vector<double> values_from(const HypothesisFit& fit, const JointModel& model);

/// How far a search goes: a first look tells which of many hypotheses deserve a whole one.
enum class SearchEffort { first_look, whole };
/// A first look that leaves more than so many times the χ² of the best does not; most leave a
/// hundred times as much.
inline constexpr double first_look_reach = 3.0;

/// Fits a hypothesis, effects included, from its numbers as they stand.
/// Errors: as JointModel and calibrate().
HypothesisFit fit_hypothesis(const Observations& seen, const Hypothesis& hypothesis,
                             const RunControl& control = {},
                             SearchEffort effort = SearchEffort::whole);

/// Fits what `near` has fitted and one effect more, from each of the given
/// starts of that effect; all other unknowns start as in `near`. The search
/// with the least χ² + k ln N is kept: starts may differ in how much is fitted.
/// Errors: as above; Error(solver_failed) when no start has an answer.
HypothesisFit fit_extended(const Observations& seen, const HypothesisFit& near,
                           const std::vector<EffectChoice>& starts, SearchEffort effort,
                           const RunControl& control = {});

/// Goes on, from where it stands, with a search that was a first look.
HypothesisFit fit_further(const Observations& seen, const HypothesisFit& fit,
                          const RunControl& control = {});

/// Central differences of the residuals at the optimum, [rows][unknowns].
Eigen::MatrixXd jacobian_at(const JointModel& model, const std::vector<double>& values);

}  // namespace rebound
