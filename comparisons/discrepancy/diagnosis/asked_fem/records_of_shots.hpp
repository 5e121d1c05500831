#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/modelled_impact.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/nuisances.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {

/// Records of force of some shots, and the restitutions stated with them, beside impacts of any
/// physics. Noise that wanders as slowly as a contact lasts hides in the force what a ball loses;
/// the restitution says it.
///
///   unknowns   the gain of the force, one of all shots, first; of every shot its speed and its
///              start [s]; gain and speeds within what is stated of them
///
/// Caution: an error of the speed moves force and time as Hertz has it, F ~ v^1.2, T ~ v^-0.2.
class RecordsOfShots {
 public:
  ///   known_gain   of the force, found elsewhere; nothing: it is an unknown
  ///
  /// Observations and shots must outlive it.
  RecordsOfShots(const Observations& seen, const std::vector<std::size_t>& shots,
                 std::optional<double> known_gain = std::nullopt)
      : seen_(seen), shots_(shots), known_gain_(known_gain), nuisances_(seen.shots.size()) {}

  /// `first_touch`: where a search for the start of a shot begins [s].
  void add_unknowns(const std::function<double(std::size_t shot)>& first_touch,
                    std::vector<CalibrationParameter>& unknowns);

  /// Whitened readings less those of `impacts`, one of each shot, and its restitution less that
  /// measured over its uncertainty.
  ///
  ///   effects   of these the faults of the measurement act on the record; others are in `impacts`
  std::vector<double> residuals(const std::vector<double>& values,
                                const std::vector<ModelledImpact>& impacts,
                                const std::vector<EffectChoice>& effects) const;

 private:
  const Observations& seen_;
  const std::vector<std::size_t>& shots_;
  std::optional<double> known_gain_;
  NuisanceUnknowns nuisances_;
};

/// Where searches for the starts of shots begin, by shot [s].
using FirstTouches = std::map<std::size_t, double>;

/// Of half a sample and more about `near`, to two samples either way, where these impacts, and
/// faults of the measurement among `effects`, leave least. A ball that sticks is pulled at once,
/// and a step that is off by a sample is a valley of its own.
FirstTouches nearest_first_touches(const Observations& seen, const std::vector<std::size_t>& shots,
                                   const std::vector<ModelledImpact>& impacts,
                                   const std::vector<EffectChoice>& effects, double gain,
                                   FirstTouches near);

}  // namespace rebound
