#include "comparisons/discrepancy/design/hidden_sizes.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

constexpr double least_share = 1e-6, first_share = 0.05, most_share = 8.0;  // of the prior scale
constexpr double good_to = 1.01;                                            // ratio of bounds

/// How far the effect may go from null in this direction.
double room(const EffectCard& card, double sign) {
  return sign > 0.0 ? card.range.highest - card.null : card.null - card.range.lowest;
}

}  // namespace

std::optional<double> smallest_size(const EffectCard& card, double sign,
                                    const std::function<bool(double)>& shows) {
  const double most = std::min(room(card, sign), most_share * card.prior_scale);
  const double least = least_share * card.prior_scale;
  double shown = std::min(most, first_share * card.prior_scale), hidden = 0.0;
  if (shows(shown)) {
    for (hidden = 0.5 * shown; hidden > least && shows(hidden); hidden *= 0.5) shown = hidden;
  } else {
    do {
      if (shown >= most) return std::nullopt;
      hidden = shown;
      shown = std::min(most, 2.0 * shown);
    } while (!shows(shown));
  }
  while (shown > good_to * hidden) {
    const double middle = std::sqrt(hidden * shown);
    (shows(middle) ? shown : hidden) = middle;
  }
  return shown;
}

std::optional<LeastVisible> least_visible(const EffectSensitivities& around, const EffectCard& card,
                                          double rise) {
  std::optional<LeastVisible> least;
  for (EffectChoice choice : around.over_its_parameters(card))
    for (const double sign : {1.0, -1.0}) {
      if (!(room(card, sign) > 0.0)) continue;
      const auto raises = [&](double size) {
        choice.size = card.null + sign * size;
        const auto risen = around.rise(choice);
        return risen && *risen >= rise;
      };
      if (least && raises(least->size)) continue;  // it shows more than the least so far
      const auto size = smallest_size(card, sign, raises);
      if (!size) return std::nullopt;
      if (least && *size <= least->size) continue;
      choice.size = card.null + sign * *size;
      least = LeastVisible{choice, *size, sign};
    }
  return least;
}

std::optional<LeastVisible> least_visible_to_first_order(const EffectSensitivities& around,
                                                         const Observations& seen,
                                                         const EffectCard& card, double rise) {
  std::optional<LeastVisible> least;
  std::size_t shown = 0;
  const double sign = room(card, 1.0) >= room(card, -1.0) ? 1.0 : -1.0;
  for (const EffectSensitivity& one : around.all()) {
    if (one.effect.name != card.name) continue;
    ++shown;
    const double size = std::sqrt(rise) * one.size_error();
    if (least && size <= least->size) continue;
    least = LeastVisible{one.effect, size, sign};
    least->effect.size = card.null + sign * size;
  }
  if (shown < small_effects(card, seen, GridDetail::coarse).size() ||
      least->size > std::min(room(card, sign), most_share * card.prior_scale))
    return std::nullopt;
  return least;
}

}  // namespace rebound
