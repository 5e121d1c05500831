#pragma once

#include <vector>

#include "comparisons/evaluation/atlas/atlas_grid.hpp"
#include "comparisons/evaluation/atlas/impact_store.hpp"
#include "comparisons/evaluation/benchmark/benchmark.hpp"
#include "comparisons/inference/calibration/law_calibration.hpp"
#include "comparisons/inference/calibration/material_calibration.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A law of the atlas, calibrated to one impact.
struct AtlasLaw {
  std::string label;
  LawRequest request;
};

/// Every law of the list, Hunt–Crossley also with its damping by Eq. (8) of the
/// sliotar paper and exactly, and the equivalent Kelvin–Voigt that follows.
const std::vector<AtlasLaw>& atlas_laws();

/// How a law did that was calibrated at one speed and used at another.
struct AtlasCell {
  std::string failure;        ///< why there is no number; empty: there is
  double force_rms = 0.0;     ///< of force over time, over the peak force
  double restitution = 0.0;   ///< difference
  double contact_time = 0.0;  ///< model over FE − 1
  double peak_force = 0.0;
  double peak_deflection = 0.0;
};

/// One material: its FE impacts, and every law from every speed to every speed.
struct AtlasEntry {
  AtlasMaterial material;
  std::vector<AtlasImpact> impacts;                        ///< [speed]
  std::vector<std::vector<std::vector<AtlasCell>>> cells;  ///< [law][calibrated at][used at]
};

struct Atlas {
  AtlasGrid grid;
  std::vector<AtlasEntry> entries;
  double impact_seconds = 0.0;  ///< wall time of the FE impacts that were run now
  int impacts_run = 0;          ///< the others were stored
};

/// Runs what is not stored, two impacts at a time, then calibrates and scores.
/// An FE impact that fails leaves its cells empty with the reason.
///
/// Limit:  a law calibrated and used at one speed agrees with benchmark()
///         -> test AtlasTest.DiagonalIsTheBenchmark; stored impacts are not run
///         again -> test AtlasTest.GoesOnWhereItWas.
/// Errors: Error(bad_input) as check_grid(); Error(corrupt_store);
///         Error(interrupted), with what is finished stored.
Atlas make_atlas(const AtlasGrid& grid, const FemRunner& run, const ImpactStore& store,
                 const RunControl& control = {});

}  // namespace rebound
