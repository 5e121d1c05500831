#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/trials/generator/baseline_pulse.hpp"
#include "comparisons/discrepancy/trials/generator/noise.hpp"

namespace trials {

/// Noise-free record of one shot and how well its speed is known.
struct RefitShot {
  std::vector<double> time;   ///< touch of the true impact is at 0 [s]
  std::vector<double> force;  ///< [N]
  double speed = 0.0;         ///< true [m/s]
  double speed_uncertainty = 0.0;
  double restitution = 0.0;                         ///< true
  std::optional<double> restitution_uncertainty{};  ///< where the data set states one
};

struct RefitProblem {
  BaselineBall ball;  ///< start of the search; the mass stays
  double gain = 1.0;  ///< true, without effects
  double gain_uncertainty = 0.0;
  Noise noise;  ///< its deviation is the uncertainty of the offset, too
  std::vector<RefitShot> shots;
};

struct Refit {
  double chi_square = 0.0;  ///< priors included
  BaselineBall ball;
  double gain = 1.0;
  double offset = 0.0;
  int iterations = 0;
  std::vector<double> residuals;  ///< whose squares sum to χ²; as many as those of the same times
};

/// Fits the baseline to noise-free records that hold an effect: what is left is what can be seen
/// of the effect in the noise of the trial.
///
///   χ² = Σ w_i² + priors of g, b, v_j + restitutions
///   w    g F(t − t_j; k, λ, v_j) + b − F_i, whitened as the noise would be
///
/// Free: k, λ ≥ 0, gain g, offset b, and start time t_j and speed v_j of every shot. Each prior is
/// centred on the true value, so that χ² is zero without an effect and has no random part.
/// Scheme: Gauss–Newton with Levenberg's damping, from one start.
Refit refit_baseline(const RefitProblem& problem);

}  // namespace trials
