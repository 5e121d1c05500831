#pragma once

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// Counts an error of the model among the errors of a history: the ripple of a contact front is
/// white, what a mesh gets wrong is shared by blocks, an eighth of the record long.
///
///   error   one standard deviation [N]
void add_numerical_error(MeasuredImpact& shot, double error);

}  // namespace rebound
