#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_gain.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/records_of_shots.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"
#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// A ball fitted in FE with nothing hidden, and what an effect beside it would gain: all numbers of
/// that fit are free, those of its material, the gain, and speed and start of every shot.
///
/// Valid:   effects that are small beside the ball; what is large bends.
/// Limit:   what it says of softening is what a fit then gains
///          -> test BesideFem.AWeakSofteningIsSeenBesideFesOwnBall
class FirstOrderInFem {
 public:
  FirstOrderInFem(const FirstOrderInFem&) = delete;  // its records look at its shots
  FirstOrderInFem& operator=(const FirstOrderInFem&) = delete;

  ///   fitted  with nothing hidden, by fit_fem_model()
  ///
  /// Errors: those of with_differences() and FE.
  FirstOrderInFem(const Observations& seen, std::vector<std::size_t> shots,
                  const HypothesisFit& lumped, const FemBelief& fem, const FittedFem& fitted);

  /// Errors: those of FE at these numbers.
  BesideFittedNumbers::Sums sums_of(const std::vector<EffectChoice>& effects) const;

  /// What the numbers of the fit leave of the residuals with these effects, to first order.
  /// Errors: those of FE at these numbers.
  Eigen::VectorXd left_with(const std::vector<EffectChoice>& effects) const;

 private:
  Eigen::VectorXd residuals_with(const std::vector<EffectChoice>& effects) const;
  std::vector<double> with_priors(const std::vector<double>& values,
                                  const std::vector<ModelledImpact>& impacts,
                                  const std::vector<EffectChoice>& effects) const;

  const Observations& seen_;
  std::vector<std::size_t> shots_;
  const FemBelief& fem_;
  RecordsOfShots records_;
  std::vector<CalibrationParameter> unknowns_;  ///< of the material, then of the records
  std::vector<double> at_fit_;
  Material material_;
  std::vector<ModelledImpact> impacts_;         ///< with nothing hidden
  std::optional<BesideFittedNumbers> numbers_;  ///< always there once constructed
};

}  // namespace rebound
