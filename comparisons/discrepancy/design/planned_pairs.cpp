#include "comparisons/discrepancy/design/planned_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t pairs = 32;
constexpr std::uint64_t apart = 1'000'003;  // of the seeds of experiments that are counted

std::optional<PlannedData> answer_of(const SynthesisFile& file,
                                     const std::vector<std::string>& effects) {
  try {
    return planned_data(file, effects);
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input && error.code() != ExitCode::solver_failed) throw;
    return std::nullopt;
  }
}

/// Residuals along the directions of one effect, in their order; its grid follows the data.
std::vector<double> along(const PlannedData& experiment, const std::string& name) {
  const auto& residuals = experiment.fit->residuals;
  const Eigen::Map<const Eigen::VectorXd> rows(residuals.data(), std::ssize(residuals));
  std::vector<double> z;
  for (const EffectSensitivity& one : experiment.around->all())
    if (one.effect.name == name) z.push_back(one.sensitivity.normalized().dot(rows));
  return z;
}

}  // namespace

PlannedPairs::PlannedPairs(const SynthesisFile& plan, const PlannedData& data)
    : plan_(plan), data_(data), without_(pairs) {
  in_parallel(pairs, [&](std::size_t k) {
    without_[k] = answer_of(experiment(k), data.around->effects());
  });
}

SynthesisFile PlannedPairs::experiment(std::size_t number) const {
  SynthesisFile file = plan_;
  file.seed += apart + number;
  return file;
}

std::optional<double> PlannedPairs::share_seen(const EffectChoice& effect,
                                               const Eigen::VectorXd& change) const {
  std::vector<double> moved(along(data_, effect.name).size(), 0.0);
  std::size_t made = 0;
  for (std::size_t k = 0; k < pairs; ++k) {
    if (!without_[k]) continue;
    SynthesisFile file = experiment(k);
    file.effects = {effect};
    const std::optional<PlannedData> with = answer_of(file, {effect.name});
    if (!with) continue;
    const std::vector<double> after = along(*with, effect.name);
    const std::vector<double> before = along(*without_[k], effect.name);
    for (std::size_t j = 0; j < std::min({moved.size(), after.size(), before.size()}); ++j)
      moved[j] += after[j] - before[j];
    ++made;
  }
  const double length = data_.around->project(change).norm();
  if (2 * made < pairs || !(length > 0.0)) return std::nullopt;
  double largest = 0.0;
  for (const double one : moved) largest = std::max(largest, std::abs(one));
  return largest / (static_cast<double>(made) * length);
}

}  // namespace rebound
