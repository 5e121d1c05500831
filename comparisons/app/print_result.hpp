#pragma once

#include <string>

#include "comparisons/app/session.hpp"

namespace rebound {

/// Prints a result as JSON or as one `key value` line per entry, error bars beside
/// the values they belong to.
void print_result(const Session& session, const Json& result);

/// Ends the command where a run is incomplete, and says where what is known lies.
/// Errors: Error(interrupted) after Ctrl-C, else Error(solver_failed), unless
///         `incomplete_because` is empty.
void require_complete(const Session& session, const std::string& file,
                      const std::string& incomplete_because);

}  // namespace rebound
