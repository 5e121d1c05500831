#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/trials/generator/impact_simulation.hpp"

namespace trials {

/// A decaying or a steady sine that is added to the force.
struct AddedSine {
  double amplitude = 0.0;  ///< [N]
  double frequency = 0.0;  ///< [Hz]
  double phase = 0.0;
  double decay_time = 0.0;  ///< 0: steady [s]
  double start = 0.0;       ///< after touch [s]
};

/// What the measuring chain does to the force, in this order: time base and delay, low-pass,
/// droop, gain, additions; then noise; then clipping and rounding.
struct MeasuringChain {
  double gain = 1.0;
  int odd_shot = -1;  ///< the shot that odd_gain is for; −1: none
  double odd_gain = 1.0;
  double offset = 0.0;       ///< [N]
  double drift = 0.0;        ///< [N/s] from the start of each record
  double delay = 0.0;        ///< [s]
  double time_factor = 1.0;  ///< reported time over true time
  double cut_off = 0.0;      ///< of each low-pass pole; 0: none [Hz]
  int poles = 0;
  double droop_time = 0.0;  ///< of a first-order high-pass; 0: none [s]
  std::optional<AddedSine> hum;
  std::optional<AddedSine> burst;
  double clip_at = 0.0;        ///< 0: never [N]
  double rounding_step = 0.0;  ///< 0: none [N]
};

/// When samples are taken.
struct Sampling {
  double rate = 0.0;        ///< [Hz]
  double first_time = 0.0;  ///< of the first sample, on the clock of the simulation [s]
  int count = 0;
};

/// Noise-free samples. Clipping and rounding are not in them.
std::vector<double> reported_force(const SimulatedImpact& impact, const MeasuringChain& chain,
                                   const Sampling& sampling, int shot);

/// Clipping and rounding, in place.
void digitise(const MeasuringChain& chain, std::vector<double>& force);

}  // namespace trials
