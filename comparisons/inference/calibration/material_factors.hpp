#pragma once

#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/material_numbers.hpp"
#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// The numbers of a believed material as unknowns, as LawFactors are those of a law: ln of a factor
/// on Young's modulus and on ratio and relaxation time of every branch, for each ball about a
/// material of its own.
///
/// Poisson ratio, elastic law and everything else of the material are held.
class MaterialFactors {
 public:
  /// Appends its unknowns. `believed`: of each ball, with equally many branches.
  MaterialFactors(std::vector<Material> believed, const std::vector<Ball>& balls,
                  std::vector<CalibrationParameter>& unknowns);

  /// The believed material with the numbers of one ball moved to these values.
  Material at(const std::vector<double>& values, std::size_t ball) const;
  /// The unknowns of one ball.
  const std::vector<std::size_t>& places(std::size_t ball) const { return places_[ball]; }

 private:
  std::vector<Material> believed_;                        ///< per ball
  std::vector<std::vector<FreeMaterialNumber>> numbers_;  ///< per ball
  std::vector<std::vector<std::size_t>> places_;          ///< per ball, per number
};

}  // namespace rebound
