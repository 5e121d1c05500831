#include "comparisons/discrepancy/diagnosis/search/excluded_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

constexpr double excluding_rise = 2.706;  // of χ²: 95 % of one side
constexpr double first_size = 0.05;       // of the prior scale
constexpr double largest_size = 8.0;      // of the prior scale
constexpr double growth = 2.0;            // from size to size of the search
constexpr double precision = 0.1;         // of a size
constexpr double smallest_size = 1e-4;    // of the prior scale: nothing smaller is told apart

/// The size from null at which one effect shows, in the direction of `sign`, or `least` where it
/// shows there already; nothing where it stays hidden. Infinite in a direction that the effect does
/// not have.
std::optional<double> visible_size(const EffectSensitivities& around, const EffectCard& card,
                                   EffectChoice choice, double sign, double seen_rise,
                                   double least) {
  const auto shows = [&](double size) {
    choice.size = card.null + sign * size;
    const auto rise = around.rise(choice);
    return rise && *rise >= seen_rise;
  };
  const double bound = sign > 0.0 ? card.range.highest - card.null : card.null - card.range.lowest;
  if (!(bound > 0.0)) return std::numeric_limits<double>::infinity();
  const double most = std::min(bound, largest_size * card.prior_scale);
  double hidden = std::min(most, least);
  if (hidden > 0.0 && shows(hidden)) return hidden;
  double size = std::min(most, std::max(growth * hidden, first_size * card.prior_scale));
  while (!shows(size)) {
    if (size >= most) return std::nullopt;
    hidden = size;
    size = std::min(most, growth * size);
  }
  while (size - hidden > std::max(precision * size, smallest_size * card.prior_scale)) {
    const double middle = 0.5 * (hidden + size);
    (shows(middle) ? size : hidden) = middle;
  }
  return size;
}

/// The size from which χ² rises by at least `rise` wherever its further parameters stand on their
/// grid and for either sign; nothing where it does not at eight times the prior scale.
std::optional<ExcludedSize> size_that_raises(const EffectSensitivities& around,
                                             const EffectCard& card, double rise) {
  ExcludedSize excluded{.name = card.name, .size = 0.0, .over = {}};
  for (const EffectChoice& choice : around.over_its_parameters(card))
    for (const double sign : {1.0, -1.0}) {
      const auto size = visible_size(around, card, choice, sign, rise, excluded.size);
      if (!size) return std::nullopt;
      if (std::isfinite(*size)) excluded.size = std::max(excluded.size, *size);
      for (const auto& [name, value] : choice.parameters) {
        const auto known =
            std::find_if(excluded.over.begin(), excluded.over.end(),
                         [&, key = name](const auto& one) { return one.parameter == key; });
        if (known == excluded.over.end())
          excluded.over.push_back({.parameter = name, .lowest = value, .highest = value});
        else
          *known = {name, std::min(known->lowest, value), std::max(known->highest, value)};
      }
    }
  return excluded;
}

}  // namespace

std::vector<ExcludedSize> excluded_sizes(const EffectSensitivities& around) {
  const std::vector<std::string>& names = around.effects();
  around.run_impacts();
  std::vector<std::optional<ExcludedSize>> found(names.size());
  in_parallel(names.size(), [&](std::size_t i) {
    const EffectCard& card = find_effect(names[i]).card;
    if (!card.is_switch && std::isfinite(card.null))
      found[i] = size_that_raises(around, card, excluding_rise);
  });
  std::vector<ExcludedSize> all;
  for (auto& one : found)
    if (one) all.push_back(std::move(*one));
  return all;
}

}  // namespace rebound
