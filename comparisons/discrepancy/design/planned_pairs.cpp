#include "comparisons/discrepancy/design/planned_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t pairs = 32;
constexpr std::uint64_t apart = 1'000'003;  // of the seeds of experiments that are counted

}  // namespace

PlannedPairs::PlannedPairs(const SynthesisFile& plan, const PlannedData& data)
    : plan_(plan), data_(data), without_(pairs) {
  in_parallel(pairs,
              [&](std::size_t k) { without_[k] = experiment(k, {}, data.around->effects()); });
}

std::optional<PlannedPairs::AlongEffects> PlannedPairs::experiment(
    std::size_t number, const std::vector<EffectChoice>& hidden,
    const std::vector<std::string>& effects) const try {
  SynthesisFile file = plan_;
  file.seed += apart + number;
  file.effects = hidden;
  const PlannedData data = planned_data(file, effects);
  const Eigen::Map<const Eigen::VectorXd> residuals(data.fit->residuals.data(),
                                                    std::ssize(data.fit->residuals));
  AlongEffects left;
  for (const EffectSensitivity& one : data.around->all())
    left[one.effect.name].push_back(one.sensitivity.normalized().dot(residuals));
  return left;
} catch (const Error& error) {
  if (error.code() != ExitCode::bad_input && error.code() != ExitCode::solver_failed) throw;
  return std::nullopt;
}

std::optional<double> PlannedPairs::share_seen(const EffectChoice& effect,
                                               const Eigen::VectorXd& change) const {
  std::vector<double> moved;
  std::size_t made = 0;
  for (std::size_t k = 0; k < pairs; ++k) {
    if (!without_[k] || !without_[k]->contains(effect.name)) continue;
    const std::vector<double>& before = without_[k]->at(effect.name);
    const auto with = experiment(k, {effect}, {effect.name});
    if (!with || !with->contains(effect.name)) continue;
    const std::vector<double>& after = with->at(effect.name);
    // Grids over further numbers follow the data, and may differ in length.
    moved.resize(std::max({moved.size(), before.size(), after.size()}));
    for (std::size_t j = 0; j < std::min(after.size(), before.size()); ++j)
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
