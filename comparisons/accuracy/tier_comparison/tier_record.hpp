#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparisons/accuracy/tier_comparison/compare_file.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A scalar with what is left open in it, by cause. Half widths.
struct RecordedScalar {
  double value = 0.0;
  double rounding = 0.0;  ///< what another order of the same additions may change
  double step = 0.0;      ///< what another time step on the same mesh may change, rounding included
  double numerical = 0.0;  ///< meshes, step and scatter together: another mesh
};

/// What the numbers of a run were computed on. Two runs of one discretisation share its error.
struct Discretisation {
  std::string scheme;  ///< "lumped", "explicit", "implicit"
  int cells = 0, vertices = 0;
  double smallest_step = 0.0;  ///< [s]
};

/// One tier at one speed.
struct TierRecord {
  std::string tier;  ///< "lumped" or "fem"
  double speed = 0.0;
  std::string separation;    ///< rule by which contact ended
  std::string input_sha256;  ///< of the effective configuration
  Discretisation discretisation;
  std::map<std::string, RecordedScalar> scalars;
  double fem_seconds = 0.0;  ///< processor time of its FE runs; no part of a baseline
};

/// Runs a case in its tiers at its speeds.
///
///   lumped   simulate() at its tolerance. numerical = step = rounding = largest of the changes by
///            a hundredth of the tolerance and by the other integrator, simulate_fast(), twice: an
///            integrator that chooses its own steps has no mesh that could be the same
///   FE       run_reference(): numerical is its bar, step the bar's share of the time step.
///            rounding: largest change when the speed changes by 2^-40, four times over: nodes
///            that engage one by one pass small changes on, and rounding is smaller than that
///
/// Every half width holds 2^-40 of the value.
/// Limit:   another instruction set of the kernel stays within `rounding`
///          -> test TierRecordTest.AnotherKernelIsRounding.
/// Errors:  those of reading and running; Error(interrupted).
std::vector<TierRecord> run_case(const CompareCase& one, const std::filesystem::path& folder,
                                 const RunControl& control);

}  // namespace rebound
