#include "comparisons/discrepancy/diagnosis/data_checks/force_before_touch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"
#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Means of the force over neighbouring samples before the touch, the earliest first.
std::vector<double> blocks_before_touch(const MeasuredImpact& shot) {
  constexpr double touch = 0.02;  // of the peak
  constexpr std::size_t fewest = 4;
  std::vector<double> force = shot.trace.force;
  const double level = level_of(force);
  for (double& one : force) one -= level;
  const double peak = *std::max_element(force.begin(), force.end());
  const double threshold = std::max(contact_threshold(shot), touch * peak);
  if (!(peak > threshold)) return {};
  const SampleRange contact = contact_window(force, threshold);
  const std::size_t block = std::max(fewest, contact.count() / 10), left = contact.count() / 7;
  if (contact.first < left) return {};
  const std::size_t count = (contact.first - left) / block;
  const std::size_t first = contact.first - left - count * block;
  std::vector<double> blocks;
  for (std::size_t k = 0; k < count; ++k)
    blocks.push_back(mean_of({force.data() + first + k * block, block}));
  return blocks;
}

/// Of all shots together.
struct LastBlocks {
  double change = 0.0;    ///< Σ d [N]
  double variance = 0.0;  ///< Σ(1 + 1/h)
  double squares = 0.0;   ///< of the first blocks about their mean [N²]
  double freedom = 0.0;
  int shots = 0;

  void add(std::span<const double> blocks) {
    const std::span<const double> early = blocks.first(2 * blocks.size() / 3);
    const double mean = mean_of(early);
    change += blocks.back() - mean;
    variance += 1.0 + 1.0 / static_cast<double>(early.size());
    for (const double one : early) squares += std::pow(one - mean, 2);
    freedom += static_cast<double>(early.size()) - 1.0;
    ++shots;
  }
};

}  // namespace

std::optional<DataCheck> force_before_touch(const Dataset& dataset) {
  constexpr std::size_t fewest_blocks = 6;
  constexpr double fewest_freedom = 3.0;
  // Filtered without delay, the contact itself begins before the touch.
  if (dataset.instrument.force_filter_class) return std::nullopt;
  LastBlocks last;
  for (const MeasuredImpact& shot : dataset.shots) {
    if (!shot.has_history()) continue;
    const std::vector<double> blocks = blocks_before_touch(shot);
    if (blocks.size() >= fewest_blocks) last.add(blocks);
  }
  if (last.freedom < fewest_freedom || !(last.squares > 0.0)) return std::nullopt;
  const double square = std::pow(last.change, 2) * last.freedom / (last.squares * last.variance);
  const double deviations = std::max(1e-6, std::sqrt(square_of_known_noise(square, last.freedom)));
  const double change = last.change / last.shots;
  return DataCheck{.what = before_touch,
                   .of = fmt::format("{} shots of {}", last.shots, dataset.name),
                   .unit = "N",
                   .measured = change,
                   .expected = 0.0,
                   .error = std::abs(change) / deviations,
                   .mended_by =
                       "a drift or a hum of the force, a filter that rings before the "
                       "touch, or something that acts at a distance"};
}

}  // namespace rebound
