#pragma once

#include <vector>

#include "comparisons/calibration/law_calibration.hpp"

namespace rebound {

/// Residuals of the force over time, [g F(t − t₀) + b − F_ref(t)]/σ at every
/// sample of the reference; F is zero before and after the contact.
class ForceTimeResiduals {
 public:
  /// Errors: Error(bad_input) as check_reference().
  ForceTimeResiduals(const std::vector<ReferenceShot>& shots, const LawCalibrationOptions& options);

  std::vector<double> operator()(const ModelOfShot& model_of, const ErrorsOfShot& errors_of) const;
  NoiseKnowledge noise() const { return noise_; }

  /// The same with their derivatives; for laws without mechanisms.
  VariedResiduals varied(const ModelOfShot& model_of, const ErrorsOfShot& errors_of,
                         const UnknownsOfShot& unknowns_of) const;

 private:
  LumpedProblem problem_for(std::size_t shot, const LumpedModel& model,
                            const RecordErrors& errors) const;

  const std::vector<ReferenceShot>& shots_;
  std::vector<double> sigma_;
  NoiseKnowledge noise_;
};

}  // namespace rebound
