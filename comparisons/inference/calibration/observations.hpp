#pragma once

#include <string>
#include <vector>

#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// A ball that was hit, whichever data sets it appears in.
struct Ball {
  std::string name;  ///< no two are alike
  Sphere sphere;
  double mass_uncertainty = 0.0;  ///< one standard deviation [kg]
};

/// A slow compression of a whole ball, from zero on.
struct SlowCompression {
  std::string label;
  std::size_t ball = 0;
  int platens = 1;                 ///< 2: the deflection is shared by two contacts
  double duration = 10.0;          ///< of the loading [s]
  std::vector<double> deflection;  ///< as measured, of all contacts together [m]
  std::vector<double> force;       ///< [N]
  std::vector<double> error;       ///< one standard deviation [N]
  bool compared_only = false;      ///< its uncertainty is assumed
};

/// Young's modulus of a block of a ball's material.
struct BlockModulus {
  std::size_t ball = 0;
  Measured modulus;  ///< [Pa]
};

/// Peaks typical of several balls, beside one of them.
struct PeaksBeside {
  std::size_t ball = 0;
  PooledPeak peak;
};

/// What a joint fit looks at: impacts of one ball or several, and how well they were measured.
///
/// A history is fitted where an impact has one, with the noise it states; of the scalars those
/// with an uncertainty.
struct Observations {
  std::vector<Ball> balls;
  std::vector<MeasuredImpact> shots;  ///< labels: no two are alike
  std::vector<SlowCompression> compressions{};
  std::vector<BlockModulus> blocks{};        ///< compared only
  std::vector<PeaksBeside> pooled_peaks{};   ///< compared only
  double gain_uncertainty = 0.0;             ///< of the force scale, one standard deviation [-]
  double deflection_gain_uncertainty = 0.0;  ///< of that of independent deflections [-]
  /// Independent samples that told the size or the colour of the noise; 0: it is known.
  double noise_freedom = 0.0;
  /// Step of a recorder that is more than twice all other noise; 0: none is [N].
  double coarse_step = 0.0;
  /// What the force read before contact, and was taken out for it would hide contacts; 0: it was
  /// left as it is [N].
  double zero_offset = 0.0;
  std::string noise_from;             ///< in words, e.g. "stated by the data set"
  std::vector<std::string> warnings;  ///< what was assumed where nothing was stated
  std::vector<std::string> missing;   ///< what would have been needed; empty: enough
};

/// The shots for which `keep` says yes, with all balls.
Observations subset(const Observations& all, const std::vector<bool>& keep);

/// As the results of a diagnosis name it, e.g. "contact-time".
std::string name_of(ObservedQuantity observable);

}  // namespace rebound
