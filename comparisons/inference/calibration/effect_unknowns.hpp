#pragma once

#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Effects as unknowns: the size of each and its further fitted parameters, one value for all
/// balls, or a size of its own for every ball where the effect says so. Sizes and numbers of any
/// sign as they are, all other numbers, and the size of a mass on a spring, by their logarithm. A
/// switch has none; the shot that a fault acts on is none.
class EffectUnknowns {
 public:
  /// Appends its unknowns; searches start from the numbers of `effects`.
  /// `of_fem`: those of their FE forms.
  EffectUnknowns(std::vector<EffectChoice> effects, bool of_fem,
                 std::vector<CalibrationParameter>& unknowns);

  /// The effects with these values.
  std::vector<EffectChoice> at(const std::vector<double>& values) const;
  /// Unknowns of effect k: sizes first, one or of every ball (none of a switch), then parameters.
  const std::vector<std::size_t>& places(std::size_t k) const { return places_[k]; }
  std::size_t sizes(std::size_t k) const { return sizes_[k]; }
  /// Those that one ball depends on.
  std::vector<std::size_t> places_of_ball(std::size_t k, std::size_t ball) const;
  std::size_t count() const { return places_.size(); }

 private:
  std::vector<EffectChoice> effects_;
  bool of_fem_;
  std::vector<std::vector<std::size_t>> places_;
  std::vector<std::size_t> sizes_;
};

}  // namespace rebound
