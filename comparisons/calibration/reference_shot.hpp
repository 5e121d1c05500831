#pragma once

#include "lumped/problem/impact.hpp"
#include "lumped/problem/result.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// One impact that a law is fitted to: an FE or lumped trace, or a measured
/// one, with its scalars.
struct ReferenceShot {
  Sphere sphere;
  Impact impact;
  Trace trace;            ///< force and deflection over the contact
  ImpactScalars scalars;  ///< of these the fits use restitution and mean deflection
  double force_uncertainty = 0.0;  ///< standard deviation of a force sample [N]; 0: unknown
};

}  // namespace rebound
