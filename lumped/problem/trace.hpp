#pragma once

#include <string>
#include <vector>

namespace rebound {

/// A column that only some tiers have, e.g. "pole_deflection_m".
struct TraceColumn {
  std::string name;  ///< with its unit as suffix
  std::vector<double> values;
};

/// The column of the force on the ball, beside what a load cell reads.
inline constexpr const char* contact_force_column = "contact_force_N";

/// A force history and the motion that goes with it. All columns have the
/// same length; time strictly increases and is zero at first touch.
struct Trace {
  std::vector<double> time;        ///< [s]
  std::vector<double> force;       ///< compression positive [N]
  std::vector<double> deflection;  ///< of the centre of mass, towards the plate positive [m]
  std::vector<TraceColumn> further;
};

}  // namespace rebound
