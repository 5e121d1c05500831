#pragma once

#include <string>
#include <vector>

#include "comparisons/io/results/json.hpp"

namespace rebound {

/// Where a result comes from: enough to make it again and to tell whether
/// its input was the same.
struct Provenance {
  std::vector<std::string> command_line;
  std::string input_file{};
  std::string input_sha256{};
  std::vector<std::string> modules{};  ///< versions as the loaded modules tell them
};

/// Version of the suite and of what it was compiled with are added.
Json to_json(const Provenance& provenance);

/// Versions of the compiler and libraries this program was built with.
std::vector<std::string> library_versions();

}  // namespace rebound
