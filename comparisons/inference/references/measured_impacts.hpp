#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// What is assumed of a scalar whose uncertainty nothing states.
struct AssumedUncertainty {
  double restitution = 0.01;   ///< one standard deviation [-]
  double contact_time = 0.01;  ///< one standard deviation over the value [-]
  double force = 0.01;         ///< one standard deviation of a sample over the peak [-]
};

/// Restitution and contact time of every shot in a folder, a data set or the
/// result of `lumped` or `fem`, without traces.
///
///   restitution   as stated, or of the trace
///   contact time  as stated, or of the trace as reported_contact_time() has it
///
/// Errors: Error(bad_input) for a shot that gives either neither as a number
///         nor by a trace, and those of reading.
std::vector<MeasuredImpact> measured_scalars(const std::filesystem::path& folder,
                                             const AssumedUncertainty& assumed);

/// The same with the force histories of all shots, 200 samples a contact at
/// most; contact_alone() says where a contact starts.
/// Errors: Error(bad_input) for a folder without traces, and as above.
std::vector<MeasuredImpact> measured_histories(const std::filesystem::path& folder,
                                               const AssumedUncertainty& assumed);

}  // namespace rebound
