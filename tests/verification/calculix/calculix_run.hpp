#pragma once

#include <filesystem>
#include <vector>

namespace rebound::calculix {

/// The ball and its material: neo-Hookean, energy μ/2 (Ī₁ − 3) + K/2 (J − 1)².
struct Ball {
  double radius = 0.0331;        ///< [m]
  double mass = 0.0896;          ///< [kg]
  double youngs_modulus = 10e6;  ///< [Pa]
  double poisson_ratio = 0.4;
};

/// Sums of the force on the plate over the steps.
struct Trace {
  std::vector<double> time;   ///< since the release (impact), share of the travel (pressing)
  std::vector<double> force;  ///< [N]
  double speed = 0.0;         ///< of the ball at its release (impact) [m/s]
};

/// The lower half pressed by `travel` onto a rigid plate in even steps.
Trace press(const Ball& ball, double travel, int steps, const std::filesystem::path& folder);

struct ImpactRequest {
  double speed = 0.0;     ///< aimed at; what came of it is in the trace [m/s]
  double duration = 0.0;  ///< after the release [s]
  int steps = 0;          ///< of it
};

/// Impact of the whole ball on a rigid plate.
///
/// CalculiX gives plane and axisymmetric elements no initial velocity, so that the
/// ball is led to its speed before the contact and then released.
Trace impact(const Ball& ball, const ImpactRequest& request, const std::filesystem::path& folder);

}  // namespace rebound::calculix
