#pragma once

#include <cstdio>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

/// Refuses `value` [SI] of `key`, which was to be as `allowed` says: Error(bad_input).
[[noreturn]] inline void refuse_out_of_range(const std::string& key, double value,
                                             const std::string& allowed) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  throw Error(ExitCode::bad_input, "out of range", {.key = key, .value = text, .allowed = allowed});
}

}  // namespace rebound
