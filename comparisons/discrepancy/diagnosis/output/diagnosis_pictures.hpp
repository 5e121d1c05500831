#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

/// Speed × phase: mean whitened residual of the believed model.
report::Matrix map_matrix(const Diagnosis& diagnosis);

/// Which effects do alike to the residuals.
report::Matrix cosine_matrix(const Diagnosis& diagnosis);

/// What a family without a formula looks like: its factor with the 95 % band.
report::Figure curve_figure(const FactorBand& band);

}  // namespace rebound
