#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {

/// Part of a contact, by the fitted model: force below a fifth of the peak,
/// up to nine tenths, above, and down again.
enum class Phase { onset, loading, peak, unloading, release, whole };

std::string name_of(Phase phase);

/// Mean whitened residual of one shot, phase and observable.
///
///   z = Σ r / √N, over its own spread when nothing is missing
struct MapCell {
  std::size_t shot = 0;
  Phase phase = Phase::whole;
  ObservedQuantity what = ObservedQuantity::force;
  int rows = 0;
  double z = 0.0;                   ///< model − data: positive where the model is too high
  double reduced_chi_square = 0.0;  ///< Σ r²/N
};

/// Where a fitted model and the data disagree.
struct ResidualMap {
  std::vector<MapCell> cells;
  double threshold = 0.0;  ///< max |z| over all cells exceeds this with the stated probability
  double largest = 0.0;    ///< max |z|

  bool quiet() const { return largest <= threshold; }
};

/// The fit's unknowns are projected out of every cell: a cell that the fit
/// could have absorbed is assessed by what it could not.
/// Limit: max |z| of noise alone exceeds the threshold as often as stated
///        -> test ResidualMapTest.NoiseIsQuiet.
ResidualMap residual_map(const Observations& seen, const HypothesisFit& fit,
                         const EffectSensitivities& around, double level, std::uint64_t seed);

}  // namespace rebound
