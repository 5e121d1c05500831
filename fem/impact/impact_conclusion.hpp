#pragma once

#include "fem/impact/impact_recorder.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"

namespace rebound::fem {

/// What a scheme knows when contact has ended.
struct ImpactEnd {
  double mass = 0.0;                 ///< [kg]
  double touch_speed = 0.0;          ///< towards the plate at time zero [m/s]
  double speed = 0.0;                ///< Σ mᵢ v_z,i / m at `time` [m/s]
  double time = 0.0;                 ///< of that speed [s]
  double last_contact = 0.0;         ///< [s]
  double initial_kinetic = 0.0;      ///< [J]
  double energy_error = 0.0;         ///< worst of the run, over the initial energy [-]
  double contact_radius_peak = 0.0;  ///< [m]
  EnergyBalance energies;            ///< at `time`
};

/// Scalars and closures of a complete run, the same for every scheme: the
/// definitions are shared, the numbers that go into them are the scheme's own. Peak force and
/// the times between crossings are of window_scalars().
///
///   rebound speed   impulse/m − v_t − g t_last
///   restitution     by momentum: (speed + g (time − t_last))/v₀
///   impulse         |∫F dt − m (v_t + speed + g time)| over the latter
///
///   v₀  the problem's speed, v_t that of the centre of mass at time zero [m/s]; the same without
///       adhesion, which makes the pole bulge towards the plate and touch before the ball is there
void conclude_impact(const FemProblem& problem, const ImpactRecorder& recorder,
                     const ImpactEnd& end, FemResult& result);

}  // namespace rebound::fem
