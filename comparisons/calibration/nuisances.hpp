#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "comparisons/calibration/calibration_problem.hpp"
#include "comparisons/calibration/reference_shot.hpp"

namespace rebound {

/// What the instrument may have got wrong, as standard deviations of a normal
/// prior about "nothing wrong". Zero: held.
struct Nuisances {
  double gain = 0.0;      ///< share of the force, one value for all shots [-]
  double trigger = 0.0;   ///< delay of the record, one a shot; force over time only [s]
  double baseline = 0.0;  ///< force offset, one a shot [N]
  double speed = 0.0;     ///< share of the approach speed, one a shot [-]

  bool any() const { return gain > 0.0 || trigger > 0.0 || baseline > 0.0 || speed > 0.0; }
};

/// What one record is taken to be: gain F(t − trigger) + baseline, of an impact
/// at speed_factor times the stated speed.
struct RecordErrors {
  double gain = 1.0;
  double trigger = 0.0;
  double baseline = 0.0;
  double speed_factor = 1.0;
};

/// Which unknowns the record errors of one shot are; absent where held.
struct NuisancePlaces {
  std::optional<std::size_t> gain, trigger, baseline, speed_factor;
};

/// Nuisances as unknowns with priors, behind those of the law.
class NuisanceUnknowns {
 public:
  NuisanceUnknowns(const Nuisances& nuisances, std::size_t shots);

  const std::vector<CalibrationParameter>& parameters() const { return parameters_; }
  /// `x` is the whole vector of unknowns, whose last ones are these.
  RecordErrors errors(const std::vector<double>& x, std::size_t shot) const;
  /// Among `unknowns` unknowns, whose last ones are these.
  NuisancePlaces places(std::size_t unknowns, std::size_t shot) const;

 private:
  Nuisances nuisances_;
  std::size_t shots_;
  std::vector<CalibrationParameter> parameters_;
};

}  // namespace rebound
