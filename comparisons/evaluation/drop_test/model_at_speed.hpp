#pragma once

#include <string>
#include <vector>

#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// A model made usable at a speed it was not fitted at.
struct ModelAtSpeed {
  LumpedModel model;                    ///< without at_speed entries that the speed needs
  std::vector<LumpedModel> neighbours;  ///< each entry next to the speed, on its own
  std::string note;                     ///< empty: the model holds at this speed as it is
};

/// Leaves alone a model that is complete at the speed. Otherwise parameters
/// that are known at single speeds are interpolated linearly in ln v, or taken
/// from the nearest entry beyond the first and last.
ModelAtSpeed model_at_speed(const LumpedProblem& problem);

}  // namespace rebound
