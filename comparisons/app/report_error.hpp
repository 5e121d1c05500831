#pragma once

#include "lumped/problem/error.hpp"

namespace rebound {

/// Prints an error, as one JSON object on standard output under --json, else
/// on standard error as
///
///   rebound: impact.toml:7:8: sphere.mass = "-1 g": the value is out of range
///            allowed: value > 0 g
///
/// and returns its exit code. Of FileErrors all are printed; in JSON they stand under "errors", the
/// first of them under "error" too.
int report_error(const Error& error, bool as_json);

}  // namespace rebound
