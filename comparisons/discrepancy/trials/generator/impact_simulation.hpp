#pragma once

#include <stdexcept>
#include <vector>

#include "comparisons/discrepancy/trials/generator/impact_model.hpp"

namespace trials {

/// The ball did not come off the plate in time.
struct NoRebound : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the load cell sees of one impact, in equal steps.
struct SimulatedImpact {
  double start = 0.0;            ///< time of the first value; touch is at 0 [s]
  double step = 0.0;             ///< [s]
  std::vector<double> force;     ///< reading of an ideal load cell [N]
  double contact_time = 0.0;     ///< to the first end of contact [s]
  double restitution = 0.0;      ///< speed of the centre of mass at the end over approach speed
  double peak_force = 0.0;       ///< [N]
  double contact_impulse = 0.0;  ///< ∫F dt of the contact force [N s]
  double momentum_change = 0.0;  ///< of the ball [N s]

  /// Straight between the values, 0 before the first.
  double at(double time) const;
};

struct SimulationTimes {
  double expected_contact = 0.0;  ///< sets the step: a 2000th [s]
  double before = 0.0;            ///< record before touch [s]
  double after = 0.0;             ///< and after the contact [s]
};

/// Solves one impact by the classical Runge–Kutta scheme of fixed step (Boost odeint).
///
/// Loss of contact is the first zero of the force on the way back. The ball may touch again:
/// integration goes on to the end of the record.
/// Errors: NoRebound when contact lasts more than eight times as long as expected.
SimulatedImpact simulate(const ImpactModel& model, const ShotOrder& shot,
                         const SimulationTimes& times);

}  // namespace trials
