#pragma once

#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"

namespace rebound {

/// Residuals of the force over time, [(1 + g) F(t − t₀) + b − F_ref(t)]/σ at every
/// sample of the reference; F is zero before and after the contact.
class ForceTimeResiduals {
 public:
  /// Errors: Error(bad_input) as check_reference().
  ForceTimeResiduals(const std::vector<MeasuredImpact>& shots,
                     const LawCalibrationOptions& options);

  std::vector<double> operator()(const ModelOfShot& model_of, const ErrorsOfShot& errors_of) const;
  NoiseKnowledge noise() const { return noise_; }

  /// The same with their derivatives; for laws without mechanisms.
  ResidualsWithJacobian with_jacobian(const ModelOfShot& model_of, const ErrorsOfShot& errors_of,
                                      const UnknownsOfShot& unknowns_of) const;

 private:
  LumpedProblem problem_for(std::size_t shot, const LumpedModel& model,
                            const MeasurementChain& chain) const;

  const std::vector<MeasuredImpact>& shots_;
  std::vector<double> sigma_;
  NoiseKnowledge noise_;
};

}  // namespace rebound
