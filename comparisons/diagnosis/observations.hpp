#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/dataset/dataset.hpp"

namespace rebound {

/// A ball that was hit, whichever data sets it appears in.
struct ObservedBall {
  std::string name;  ///< no two are alike
  Sphere sphere;
  double mass_uncertainty = 0.0;  ///< one standard deviation [kg]
};

/// A force history with its errors.
struct ForceHistory {
  std::vector<double> time;   ///< [s], the data set's own clock
  std::vector<double> force;  ///< [N]
  double noise = 0.0;         ///< one standard deviation a sample, white [N]
  /// Standard deviation of an error that neighbours share, such as that of a
  /// discretised model: common to every block of so many samples. [N]
  double shared_error = 0.0;
  std::size_t shared_by = 1;
};

/// Residuals (model − data) divided by the errors of a history: white noise
/// and, within blocks, the shared error.
///
///   covariance of a block of N   σ² I + u² 1 1ᵀ
///
/// The mean of a block is divided by √(σ² + N u²)/σ as well: however many its
/// samples, a block is not known better than u.
/// Limit: u = 0 divides by σ alone -> test ObservationsTest.SharedErrorBoundsABlock.
std::vector<double> whitened(const ForceHistory& history, const std::vector<double>& model);

enum class ObservedQuantity { force, restitution, contact_time, peak_force, peak_deflection, mean_deflection };

/// As the results of a diagnosis name it, e.g. "contact-time".
std::string name_of(ObservedQuantity observable);

/// A scalar with one standard deviation.
struct ObservedScalar {
  ObservedQuantity what = ObservedQuantity::restitution;
  double value = 0.0;        ///< SI
  double uncertainty = 0.0;  ///< SI, > 0
};

/// One impact as a diagnosis sees it.
struct ObservedShot {
  std::string label;             ///< e.g. "core A, 15 m/s"; no two are alike
  std::size_t ball = 0;          ///< index into Observations::balls
  double speed = 0.0;            ///< nominal [m/s]
  double speed_uncertainty = 0;  ///< one standard deviation [m/s]
  double contact_threshold = 0;  ///< of reported contact times [N]
  std::optional<ForceHistory> history;
  std::vector<ObservedScalar> scalars;
  /// Measured restitution: what a damping formula is given, as the sliotar
  /// paper gave it; empty: not measured.
  std::optional<double> restitution;
};

/// Everything a diagnosis may look at: what was measured, and how well.
struct Observations {
  std::vector<ObservedBall> balls;
  std::vector<ObservedShot> shots;
  double gain_uncertainty = 0.0;  ///< of the force scale, one standard deviation [-]
  std::string noise_from;         ///< in words, e.g. "stated by the data set"
  std::vector<std::string> warnings;  ///< what was assumed where nothing was stated
  std::vector<std::string> missing;   ///< what would have been needed; empty: enough
};

/// Collects the shots of data sets.
///
/// Noise of a force sample: as stated, or else the scatter before contact.
/// Histories of more than about 600 samples a contact are averaged in blocks,
/// their noise with them. Beside a history only the restitution is kept as a
/// scalar: the other scalars repeat what the history says. Two data sets whose
/// mass and diameter agree within their uncertainties are of one ball.
///
/// Caution: noise is taken as white.
Observations observe(const std::vector<Dataset>& datasets);

/// The shots for which `keep` says yes, with all balls.
Observations subset(const Observations& all, const std::vector<bool>& keep);

}  // namespace rebound
