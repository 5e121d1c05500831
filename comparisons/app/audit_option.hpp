#pragma once

#include <string>
#include <vector>

#include "comparisons/app/session.hpp"

namespace rebound {

/// `benchmark --audit`: the assumptions of the paper's models against the ball
/// of an FE impact file, at these speeds [m/s].
ExitCode run_audit_option(const Session& session, const std::string& path,
                          const std::vector<double>& speeds);

}  // namespace rebound
