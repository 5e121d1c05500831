#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "comparisons/discrepancy/trials/generator/fem_ball.hpp"
#include "comparisons/discrepancy/trials/generator/impact_simulation.hpp"

namespace trials {

/// Impacts in finite elements, computed by a program of its own: `PROGRAM fem DECK --out FOLDER`.
///
/// Nothing of it is linked; what it says comes back as a file. Impacts that were computed once are
/// kept by their decks.
class FemProgram {
 public:
  /// Errors: std::runtime_error where there is no such program.
  explicit FemProgram(const std::filesystem::path& program);

  /// The record ends soon after the contact; a load cell that rings on is carried on as the free
  /// vibration of its plate, 1.5 contact times further.
  /// Errors: NoRebound where the program refuses the ball or finds no result, std::runtime_error
  ///         where it does not work; both with what it said.
  const SimulatedImpact& impact(const FemBall& ball, const FemImpact& impact);

 private:
  std::filesystem::path program_;
  std::map<std::string, SimulatedImpact> known_;
};

/// Reads the result folder of one impact: contact time, restitution and peak from result.json, the
/// force at the load cell from trace.csv, in equal steps.
/// Errors: std::runtime_error where a file is no such result.
SimulatedImpact read_fem_impact(const std::filesystem::path& folder);

/// Carries a load cell's reading on for that time: what it reads obeys the plate's own equation
/// once the ball has left.
///
///   r'' + 2 ζ ω r' + ω² r = 0,   ω² = k/M,   from the last value and slope
void let_ring_on(const FemPlate& plate, double duration, SimulatedImpact& impact);

}  // namespace trials
