#pragma once

#include <functional>
#include <vector>

#include "comparisons/calibration/law_calibration.hpp"
#include "lumped/integration/force_deflection.hpp"

namespace rebound {

/// The reference side of a force–deflection fit, prepared once.
class ForceDeflectionResiduals {
 public:
  /// Errors: Error(bad_input) for shots without samples or of unequal columns.
  ForceDeflectionResiduals(const std::vector<ReferenceShot>& shots,
                           const LawCalibrationOptions& options);

  /// Residuals of all shots, in their order; `model_of(i)` is the law for shot i.
  std::vector<double> operator()(const std::function<LumpedModel(std::size_t)>& model_of) const;

  /// known when every shot states its force uncertainty.
  NoiseKnowledge noise() const { return noise_; }

 private:
  struct Prepared {
    const ReferenceShot* shot;
    DeflectionPoints points;
    std::vector<double> force;  ///< of the reference, at the points [N]
    double sigma;
  };
  std::vector<Prepared> shots_;
  NoiseKnowledge noise_ = NoiseKnowledge::known;
};

}  // namespace rebound
