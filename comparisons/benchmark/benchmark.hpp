#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/calibration/reference_shot.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/run_control.hpp"

/// Every law against every reference: one scored matrix.
namespace rebound {

/// A row: a law with its numbers.
struct BenchmarkEntry {
  std::string label;
  LumpedModel model;
};

/// Scalars that were measured, where they were.
struct MeasuredScalars {
  std::optional<double> restitution;
  std::optional<double> contact_time;     ///< by the separation rule [s]
  std::optional<double> peak_force;       ///< [N]
  std::optional<double> peak_deflection;  ///< [m]
  std::optional<double> mean_deflection;  ///< [m]
};

/// A column: one impact, its reference trace, and what was measured beside it.
struct BenchmarkReference {
  std::string label;
  ReferenceShot shot;
  MeasuredScalars measured;
};

/// model/reference − 1; empty where the reference has no such value.
struct ScalarErrors {
  std::optional<double> peak_force;
  std::optional<double> peak_deflection;
  std::optional<double> mean_deflection;
  std::optional<double> contact_time;       ///< both by the separation rule
  std::optional<double> contact_time_1pct;  ///< both between crossings of 1 % of peak
  std::optional<double> restitution;
};

/// One law at one impact.
struct BenchmarkCell {
  std::string failure;  ///< why the law gives no trace here; empty: it does
  ImpactScalars scalars;
  ScalarErrors against_reference;
  ScalarErrors against_measured;
  /// Root mean square of the force difference over the peak force of the
  /// reference: at equal times from first touch over the longer of the two
  /// contacts, force zero after its end; and at equal deflections, branch by
  /// branch, at the samples of the reference.
  double force_time_rms = 0.0;
  double force_deflection_rms = 0.0;
};

struct BenchmarkMatrix {
  std::vector<std::string> laws;                  ///< row labels
  std::vector<std::string> references;            ///< column labels
  std::vector<double> speeds;                     ///< of the columns [m/s]
  std::vector<std::vector<BenchmarkCell>> cells;  ///< [law][reference]
};

/// Simulates every entry at every reference and scores it. A law that has no
/// answer somewhere (no damping for that speed, contact that does not end)
/// fills its cell with the reason; nothing is left out.
///
/// Limit:  a law against its own trace scores zero -> test BenchmarkTest.OwnTraceScoresZero.
/// Errors: Error(bad_input) for no entries or references, or a reference
///         without a usable trace; Error(interrupted) when asked to stop.
BenchmarkMatrix benchmark(const std::vector<BenchmarkEntry>& entries,
                          const std::vector<BenchmarkReference>& references,
                          const RunControl& control = {});

}  // namespace rebound
