#pragma once

#include <functional>

namespace rebound {

/// How a long computation talks to whoever started it. Both may be empty.
struct RunControl {
  std::function<bool()> interrupted;     ///< asked now and then; true: stop and keep what is known
  std::function<void(double)> progress;  ///< fraction done in [0, 1]
};

}  // namespace rebound
