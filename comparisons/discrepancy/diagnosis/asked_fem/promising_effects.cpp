#include "comparisons/discrepancy/diagnosis/asked_fem/promising_effects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"

namespace rebound {
namespace {

constexpr double worth_a_fit = 25.0;  // in χ²: gains of nulls are in the README
constexpr int most_of_a_kind = 4;

/// Where its search starts, and what it would gain to first order.
struct PromisingEffect {
  EffectChoice start;
  double gain = 0.0;
};

/// At the size where it gains most, within what first order can say and the effect may be; nothing
/// where it would have the other sign. Most faults of the measurement are their size times
/// something, so that first order is the whole.
std::optional<EffectChoice> moved_to_its_size(EffectChoice start, double factor) {
  constexpr double least = 0.05, most = 5.0;
  const EffectCard& card = find_effect(start.name).card;
  if (!std::isfinite(card.null)) return start;  // a level, no share of anything
  if (!is_measurement(start.name))
    factor = std::copysign(std::clamp(std::abs(factor), least, most), factor);
  start.size = card.null + (start.size - card.null) * factor;
  return card.range.contains(start.size) ? std::optional(std::move(start)) : std::nullopt;
}

using Promising = std::vector<PromisingEffect>;

void sort_best_first(Promising& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.gain > b.gain; });
}

/// Of one effect, at the size where each gains most; best first.
Promising moved_starts(const std::vector<EffectChoice>& starts,
                       std::span<const FirstOrderGain> gains) {
  Promising moved;
  for (std::size_t k = 0; k < starts.size(); ++k)
    if (auto start = moved_to_its_size(starts[k], gains[k].factor);
        start && gains[k].chi_square > 0.0)
      moved.push_back({.start = *std::move(start), .gain = gains[k].chi_square});
  sort_best_first(moved);
  return moved;
}

/// The best that searches from a few starts find: of what swings, every instant and frequency has a
/// valley of its own.
PromisingEffect searched(const FirstOrderOfBalls& around, const Promising& starts,
                         const RunControl& control) {
  constexpr std::size_t most_searches = 4;
  const auto found = fit_each<PromisingEffect>(
      std::min(most_searches, starts.size()), control, [&](std::size_t k) {
        const auto [choice, gain] = around.searched(starts[k].start, control);
        return PromisingEffect{.start = choice, .gain = gain};
      });
  PromisingEffect best = starts.front();
  for (const auto& one : found)
    if (one && one->gain > best.gain) best = *one;
  return best;
}

std::vector<EffectChoice> best_of_each_kind(const Promising& promising) {
  std::vector<EffectChoice> best;
  int physical = 0, faults = 0;
  for (const PromisingEffect& one : promising) {
    int& count = is_measurement(one.start.name) ? faults : physical;
    if (count++ < most_of_a_kind) best.push_back(one.start);
  }
  return best;
}

}  // namespace

std::vector<EffectChoice> promising_effects(const StartsOfEffects& starts,
                                            const FirstOrderOfBalls& around,
                                            const RunControl& control) {
  std::vector<EffectChoice> all;
  for (const std::vector<EffectChoice>& of_one : starts)
    all.insert(all.end(), of_one.begin(), of_one.end());
  const std::vector<FirstOrderGain> gains = around.gains(all, control);
  Promising promising;
  std::size_t first = 0;
  for (const std::vector<EffectChoice>& of_one : starts) {
    const Promising moved = moved_starts(of_one, std::span(gains).subspan(first, of_one.size()));
    first += of_one.size();
    if (moved.empty()) continue;
    const bool on_the_record = is_measurement(moved.front().start.name);
    const PromisingEffect best = on_the_record ? searched(around, moved, control) : moved.front();
    if (best.gain >= worth_a_fit) promising.push_back(best);
  }
  sort_best_first(promising);
  return best_of_each_kind(promising);
}

}  // namespace rebound
