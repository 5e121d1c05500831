#include "comparisons/evaluation/benchmark/benchmark.hpp"

#include "lumped/problem/error.hpp"

namespace rebound {

BenchmarkMatrix benchmark(const std::vector<BenchmarkEntry>& entries,
                          const std::vector<MeasuredImpact>& references,
                          const RunControl& control) {
  if (entries.empty()) throw Error(ExitCode::bad_input, "a benchmark needs at least one law");
  if (references.empty())
    throw Error(ExitCode::bad_input, "a benchmark needs at least one reference");
  BenchmarkMatrix matrix;
  for (const auto& reference : references) {
    check_scorable(reference);
    matrix.references.push_back(reference.label);
    matrix.speeds.push_back(reference.impact.speed);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "the benchmark was interrupted before it ended");
    matrix.laws.push_back(entries[i].label);
    auto& row = matrix.cells.emplace_back();
    for (const auto& reference : references) row.push_back(score_law(entries[i].model, reference));
    if (control.progress)
      control.progress(static_cast<double>(i + 1) / static_cast<double>(entries.size()));
  }
  return matrix;
}

}  // namespace rebound
