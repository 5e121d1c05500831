#pragma once

#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"

namespace rebound {

/// Residuals of stated scalars, (model − stated)/σ, for impacts without a record: restitutions of
/// drops, speeds of gates, contact times.
///
/// Contact time is the model's above the instrument's threshold, where there is one.
/// Caution: an error of the approach speed moves a scalar by its slope over speed times that error;
///          it is not counted here.
class ScalarResiduals {
 public:
  /// Errors: Error(bad_input) for no shots, or a shot without a scalar that states its uncertainty.
  explicit ScalarResiduals(const std::vector<MeasuredImpact>& shots);

  std::vector<double> operator()(const ModelOfShot& model_of) const;

 private:
  const std::vector<MeasuredImpact>& shots_;
};

/// A record of the size that such a shot must have had, to guess unknowns from: a half sine of the
/// impulse m v (1 + e).
///
///   T   as stated; or π J/(2 F) of a stated peak; or Hertz's, 2.94 x/v, x from ½ m v² = κ
///   x^(n+1)/(n+1)
///       of a stiffness that is fixed
///
/// Errors: Error(bad_input) with key "fixed.stiffness" where nothing tells the stiffness: a
///         restitution alone does not.
std::vector<MeasuredImpact> with_guessed_records(const std::vector<MeasuredImpact>& shots,
                                                 const std::string& law,
                                                 const ParameterValues& fixed);

/// A law fitted to the scalars that the shots state.
/// Errors: Error(bad_input) as above, and with key "nuisance" for one that belongs to a record.
LawCalibration calibrate_to_scalars(const LawRequest& request,
                                    const std::vector<MeasuredImpact>& shots,
                                    const LawCalibrationOptions& options,
                                    const RunControl& control);

}  // namespace rebound
