#pragma once

#include <string_view>
#include <vector>

namespace rebound {

struct StoredTrials {
  std::string_view name, text;
};

/// Tables of blind trials that are kept (`../trials/`), as they were when the program was built.
const std::vector<StoredTrials>& stored_trials();

}  // namespace rebound
