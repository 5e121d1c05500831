#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/figure.hpp"

namespace rebound {

/// Reduced χ² of every shot over its speed, before and after, beside that of the noise; shots that
/// no fit saw have marks of their own.
report::Figure gap_figure(const Diagnosis& diagnosis);

/// Residuals over time before and after, one figure a shot: first those that no fit saw.
std::vector<report::Figure> residual_figures(const Diagnosis& diagnosis);

/// Force histories with the models before and after, in the same order.
std::vector<report::Figure> history_figures(const Diagnosis& diagnosis);

}  // namespace rebound
