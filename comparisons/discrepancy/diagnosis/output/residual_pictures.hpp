#pragma once

#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "comparisons/io/report/figure.hpp"

namespace rebound {

/// Residuals of a history, gathered so that what lies together can be seen beside the noise.
///
///   z = Σ r / √n over n neighbouring samples, r the whitened residuals (model − data)
///
///   time   middle of the n samples [s]
///   z      of unit variance where the model is right [-]
///
/// Limit: a model that is right gives unit variance, a constant offset of c σ under white noise
///        c √n -> test ResidualPicturesTest.
struct GatheredResiduals {
  std::vector<double> time, z;
};

/// In about `points` groups of equal size; a rest that fills no group is left out.
GatheredResiduals gathered_residuals(const MeasuredImpact& measured,
                                     const std::vector<double>& model, std::size_t points = 50);

/// Names of the models in every picture of a diagnosis.
inline constexpr auto before_name = "believed model, refitted", after_name = "with what is missing";

/// Residuals before and, where there are any, after, over the range of the noise.
report::Figure residual_figure(const MeasuredImpact& measured, const std::vector<double>& before,
                               const std::vector<double>* after, report::Origin origin);

}  // namespace rebound
