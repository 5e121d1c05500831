#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// What is left of one shot.
struct ShotGap {
  int rows = 0;                     ///< of data
  double reduced_chi_square = 0.0;  ///< Σ r² over them

  /// Of it when nothing is missing, √(2/rows).
  double deviation() const;
};

/// Shot by shot, of the shots that a fit saw.
std::vector<ShotGap> gaps_of_shots(const HypothesisFit& fit);

/// What is left of shots that the fit never saw: physics and the instrument's
/// common numbers stay as fitted, start of contact and speed of each new shot
/// are found within their priors.
struct HeldOutGap {
  double chi_square = 0.0;  ///< Σ r² over their data
  double reduced_chi_square = 0.0;
  double deviation = 0.0;  ///< of it when nothing is missing, √(2/rows + 2/ν), ν samples of quiet
  std::vector<ShotGap> of_shots;
  std::vector<std::vector<double>> force;  ///< predicted, per shot, at the data's instants
};
HeldOutGap predict_unseen(const Observations& unseen, const HypothesisFit& fit);

}  // namespace rebound
