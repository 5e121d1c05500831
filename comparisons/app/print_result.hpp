#pragma once

#include <string>
#include <vector>

#include "comparisons/app/session.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Prints a result as JSON or as one `key value` line per entry, error bars beside
/// the values they belong to.
void print_result(const Session& session, const Json& result);

/// The effects that act on the impact itself. Faults of the measurement, which a diagnosis may
/// have put into a model file, are named on standard error: they belong to a data set.
std::vector<EffectChoice> without_measurement(const std::vector<EffectChoice>& effects);

/// Ends the command where a run is incomplete, and says where what is known lies.
/// Errors: Error(interrupted) after Ctrl-C, else Error(solver_failed), unless
///         `incomplete_because` is empty.
void require_complete(const Session& session, const std::string& file,
                      const std::string& incomplete_because);

}  // namespace rebound
