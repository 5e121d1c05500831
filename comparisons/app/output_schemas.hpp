#pragma once

#include <string>

#include "comparisons/io/results/json.hpp"

namespace rebound {

/// JSON schema of what a command prints under `--json`, as stored in `output_schemas/`, with the
/// schemas that it refers to under `$defs`. "error" is what every command prints where it fails.
/// A command without one throws Error.
Json output_schema(const std::string& command);

}  // namespace rebound
