#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/references/law_score.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/run_control.hpp"

/// Every law against every reference: one scored matrix.
namespace rebound {

/// A row: a law with its numbers.
struct BenchmarkEntry {
  std::string label;
  LumpedModel model;
};

struct BenchmarkMatrix {
  std::vector<std::string> laws;             ///< row labels
  std::vector<std::string> references;       ///< column labels
  std::vector<double> speeds;                ///< of the columns [m/s]
  std::vector<std::vector<LawScore>> cells;  ///< [law][reference]
};

/// Simulates every entry at every reference and scores it, against the trace of the contact
/// alone with its scalars, and against the scalars measured beside it. A law that has no
/// answer somewhere (no damping for that speed, contact that does not end)
/// fills its cell with the reason; nothing is left out.
///
/// Limit:  a law against its own trace scores zero -> test BenchmarkTest.OwnTraceScoresZero.
/// Errors: Error(bad_input) for no entries or references, or a reference
///         without a usable trace; Error(interrupted) when asked to stop.
BenchmarkMatrix benchmark(const std::vector<BenchmarkEntry>& entries,
                          const std::vector<MeasuredImpact>& references,
                          const RunControl& control = {});

}  // namespace rebound
