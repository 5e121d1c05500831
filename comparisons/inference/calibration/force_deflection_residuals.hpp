#pragma once

#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"
#include "lumped/integration/force_deflection.hpp"

namespace rebound {

/// The reference side of a force–deflection fit, prepared once.
class ForceDeflectionResiduals {
 public:
  /// Errors: Error(bad_input) as check_reference().
  ForceDeflectionResiduals(const std::vector<MeasuredImpact>& shots,
                           const LawCalibrationOptions& options);

  /// Residuals of all shots, in their order; without `errors_of` every record
  /// is taken as it stands.
  std::vector<double> operator()(const ModelOfShot& model_of,
                                 const ErrorsOfShot& errors_of = {}) const;

  /// known when every shot states its force uncertainty.
  NoiseKnowledge noise() const { return noise_; }

  /// The same with their derivatives; for laws without mechanisms.
  ResidualsWithJacobian with_jacobian(const ModelOfShot& model_of, const ErrorsOfShot& errors_of,
                                      const UnknownsOfShot& unknowns_of) const;

 private:
  struct Prepared {
    const MeasuredImpact* shot;
    DeflectionPoints points;
    std::vector<double> force;  ///< of the reference, at the points [N]
    double sigma;
  };
  LumpedProblem problem_for(const Prepared& prepared, const LumpedModel& model,
                            const MeasurementChain& chain) const;

  std::vector<Prepared> shots_;
  NoiseKnowledge noise_;
};

}  // namespace rebound
