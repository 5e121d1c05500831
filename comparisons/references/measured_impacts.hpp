#pragma once

#include <filesystem>
#include <vector>

#include "comparisons/calibration/material_calibration.hpp"

namespace rebound {

/// What is assumed of a scalar whose uncertainty nothing states.
struct AssumedUncertainty {
  double restitution = 0.01;   ///< one standard deviation [-]
  double contact_time = 0.01;  ///< one standard deviation over the value [-]
  double force = 0.01;         ///< one standard deviation of a sample over the peak [-]
};

/// A ball and its impacts as a material is fitted to them.
struct MeasuredBall {
  Sphere sphere;
  std::vector<MeasuredImpact> impacts;
  std::vector<std::string> labels;  ///< one an impact
  std::vector<std::string> notes;   ///< what was assumed
};

/// Restitution and contact time of every shot in a folder: a data set, or the
/// result of `lumped` or `fem`.
///
///   restitution   as stated, or of the trace
///   contact time  as stated, or the time of the trace above the threshold
///
/// Errors: Error(bad_input) for a shot that gives either neither as a number
///         nor by a trace, and those of reading.
MeasuredBall measured_ball(const std::filesystem::path& folder, const AssumedUncertainty& assumed);

/// The same with the force histories of all shots, 200 samples a contact at
/// most; measured_shot() says where a contact starts.
/// Errors: Error(bad_input) for a folder without traces, and as above.
MeasuredBall measured_histories(const std::filesystem::path& folder,
                                const AssumedUncertainty& assumed);

}  // namespace rebound
