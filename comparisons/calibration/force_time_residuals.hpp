#pragma once

#include <vector>

#include "comparisons/calibration/law_calibration.hpp"

namespace rebound {

/// Residuals of the force over time, [g F(t − t₀) + b − F_ref(t)]/σ at every
/// sample of the reference; F is zero before and after the contact.
///
/// The law's trace is sampled at 1001 instants and taken linearly between
/// them: 1e-6 of the peak force.
class ForceTimeResiduals {
 public:
  /// Errors: Error(bad_input) as check_reference().
  ForceTimeResiduals(const std::vector<ReferenceShot>& shots, const LawCalibrationOptions& options);

  std::vector<double> operator()(const ModelOfShot& model_of, const ErrorsOfShot& errors_of) const;
  NoiseKnowledge noise() const { return noise_; }

 private:
  const std::vector<ReferenceShot>& shots_;
  std::vector<double> sigma_;
  NoiseKnowledge noise_;
};

}  // namespace rebound
