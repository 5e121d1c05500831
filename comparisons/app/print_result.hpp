#pragma once

#include "comparisons/app/session.hpp"

namespace rebound {

/// Prints a result as JSON or as one `key value` line per entry.
void print_result(const Session& session, const Json& result);

}  // namespace rebound
