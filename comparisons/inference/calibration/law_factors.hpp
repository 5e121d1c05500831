#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// The numbers of a law that a fit looks for: those without a default, less the damping where a
/// formula gives it.
std::vector<std::string> unknown_numbers(const LumpedModel& model);

/// The model with one of its numbers multiplied, at every speed.
LumpedModel scaled(LumpedModel model, const std::string& number, double factor);

/// The numbers of a believed law as unknowns: ln of a factor on every free parameter, for each
/// ball. LawUnknowns searches for numbers that nobody believes yet.
///
/// A law's parameter is free when its card gives it no default. Parameters
/// fitted speed by speed keep their ratios: one factor moves all. Damping that
/// is given by a restitution and a formula follows from it, and is not free.
class LawFactors {
 public:
  /// Appends its unknowns.
  LawFactors(LumpedModel believed, const std::vector<Ball>& balls,
             std::vector<CalibrationParameter>& unknowns);

  /// The believed model with the numbers of one ball moved to these values.
  LumpedModel at(const std::vector<double>& values, std::size_t ball) const;
  /// The unknowns of one ball.
  const std::vector<std::size_t>& places(std::size_t ball) const { return places_[ball]; }

 private:
  LumpedModel believed_;
  std::vector<std::string> parameters_;
  std::vector<std::vector<std::size_t>> places_;  ///< per ball, per parameter
};

}  // namespace rebound
