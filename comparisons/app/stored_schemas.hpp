#pragma once

#include <string_view>
#include <vector>

namespace rebound {

struct StoredSchema {
  std::string_view name, text;
};

/// The files of `output_schemas/`, as they were when the program was built.
const std::vector<StoredSchema>& stored_schemas();

}  // namespace rebound
