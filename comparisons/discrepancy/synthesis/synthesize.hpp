#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "lumped/problem/plate.hpp"
#include "lumped/problem/result.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What a solver of either tier gives back for one impact.
struct SimulatedImpact {
  Trace trace;
  ImpactScalars scalars;
  Plate plate;    ///< that goes on ringing after the ball has left
  int cells = 0;  ///< of the mesh; lumped: none
};

/// Runs one impact of the hidden model; effects are already in it.
using ImpactSimulator = std::function<SimulatedImpact(const Sphere&, const Impact&)>;

/// What happened in one shot and the data set does not say.
struct HiddenShot {
  double speed = 0.0;     ///< true [m/s]
  ImpactScalars scalars;  ///< true
  int cells = 0;          ///< of the mesh; lumped: none
};

/// A synthetic experiment: what the laboratory would hand over, and the truth.
struct Synthesis {
  Dataset dataset;
  double true_mass = 0.0;        ///< [kg]
  double true_force_gain = 0.0;  ///< drawn from the stated uncertainty and added to any effect [-]
  std::vector<HiddenShot> hidden;
};

/// Makes the experiment.
///
///   mass, gain   drawn once from their stated uncertainties
///   speed        drawn for every shot from its own
///   force        reported_force() of the impact on an even time grid, plus
///                noise of the stated standard deviation, white or with its correlation time
///   deflection   where it is independent, reported_deflection() of the impact on the same grid
///                plus white noise of its own; its scale is drawn as the gain is
///   scalars      with their stated errors; contact times in whole frames, where a camera's rate is
///                stated
///   first touch  scatters by the trigger's jitter
///
/// Every shot has its own stream of numbers from seed and place, so that data
/// do not depend on the order in which shots are made.
/// Limit:  without noise and uncertainty the data are the model's trace
///         -> test SynthesizeTest.IdealExperimentIsTheModel.
/// Errors: what the simulator throws; Error(bad_input) for a sampling rate too
///         low for the contact; Error(interrupted).
Synthesis synthesize(const SynthesisFile& file, const ImpactSimulator& simulate,
                     const RunControl& control = {});

/// The impacts of the file's model, by the tier it names: CVODE or FE.
ImpactSimulator simulator_of(const SynthesisFile& file, const RunControl& control);

}  // namespace rebound
