#include "comparisons/accuracy/verification/verification_suite.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

VerificationTable SuiteOutcome::rows() const {
  VerificationTable table;
  for (const Complete& one : complete)
    table.insert(table.end(), one.part.rows.begin(), one.part.rows.end());
  return table;
}

SuiteOutcome run_suite(const std::vector<SuitePart>& parts, const RunControl& control) {
  std::vector<std::optional<VerificationPart>> found(parts.size());
  double all = 0.0, done = 0.0;
  for (const SuitePart& part : parts) all += part.seconds;
  std::mutex guard;
  const auto stopped = [&] { return control.interrupted && control.interrupted(); };
  // Longest first, so that the threads end together.
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].seconds > parts[b].seconds;
  });
  in_parallel(parts.size(), [&](std::size_t place) {
    const std::size_t i = order[place];
    if (stopped()) return;
    try {
      found[i] = parts[i].run({.interrupted = control.interrupted, .progress = {}});
    } catch (const Error& error) {
      if (error.code() != ExitCode::interrupted) throw;
      return;
    }
    const std::lock_guard lock(guard);
    done += parts[i].seconds;
    if (control.progress) control.progress(done / all);
  });
  SuiteOutcome outcome;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (found[i])
      outcome.complete.push_back({parts[i].name, std::move(*found[i])});
    else
      outcome.not_run.push_back(parts[i].name);
  }
  return outcome;
}

}  // namespace rebound
