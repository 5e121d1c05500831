#pragma once

#include <functional>
#include <optional>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

/// Sizes of a hidden effect at which it does something.
namespace rebound {

/// An effect at the further numbers, and with the sign, at which it shows least.
struct LeastVisible {
  EffectChoice effect;  ///< its size is the one that raises χ² by what was asked
  double size = 0.0;    ///< distance from the size of no effect, SI
  double sign = 1.0;
};

/// The smallest distance from null, to a hundredth of it, at which `shows` says yes, between a
/// millionth of the prior scale and eight times it; nothing where it says no throughout.
/// `shows` must go from no to yes once.
std::optional<double> smallest_size(const EffectCard& card, double sign,
                                    const std::function<bool(double)>& shows);

/// The size from which χ² rises by at least `rise` wherever the further numbers stand on their grid
/// and for either sign, and where that is; nothing where it does not rise so far somewhere.
///
/// Limit: what it finds raises χ² by what was asked, to some per cent
///        -> test HiddenSizesTest.TheSizeRaisesChiSquareByWhatWasAsked.
std::optional<LeastVisible> least_visible(const EffectSensitivities& around, const EffectCard& card,
                                          double rise);

/// The same to first order in the size, for a believed FE model, of which every size is an impact
/// of each shot.
std::optional<LeastVisible> least_visible_to_first_order(const EffectSensitivities& around,
                                                         const Observations& seen,
                                                         const EffectCard& card, double rise);

}  // namespace rebound
