#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/figure.hpp"

namespace rebound {

/// Reduced χ² of every shot over its speed, before and after, beside that of the noise; shots that
/// no fit saw have marks of their own. Without a series where no shot has data, as of slow
/// compressions alone.
report::Figure gap_figure(const Diagnosis& diagnosis);

/// One figure a shot with a force history: first those that no fit saw.
struct ShotFigures {
  std::vector<report::Figure> residuals;  ///< over time, before and after
  std::vector<report::Figure> histories;  ///< the force, with the models before and after
};
ShotFigures shot_figures(const Diagnosis& diagnosis);

}  // namespace rebound
