#pragma once

#include <Eigen/Core>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// The loop that an impact goes through in deflection and velocity.
///
///   θ = asin(x/x_max) while loading, π less that while unloading
///   u = (2θ/π)^0.7 while loading, 2 − [(θ_e − θ)/(θ_e − π/2)]^0.7 while unloading
///
/// θ runs as time does, u is finer where a contact begins and ends: forces bend there.
struct Loop {
  double largest_deflection = 0.0;  ///< x_max [m]
  double end = 0.0;                 ///< θ_e, where contact ends [rad]

  double angle(double deflection, double velocity) const;
  /// u from 0 to 2; below zero before first touch and after separation.
  double position(double deflection, double velocity) const;
  double angle_at(double position) const;
};

/// The sample with which a contact ends: the first one past the peak where the mean over the next
/// samples, a sixtieth of the record, is no more than noise.
std::size_t last_sample_of_contact(const MeasuredImpact& measured, double baseline);

/// The motion of one measured impact, and what its force has beyond the law's.
///
///   v(t) = v₀ + ∫(g − F/m) dt,   x(t) = ∫v dt,   y = F − F_law along x and v
///
/// F is the reading with its baseline and gain taken out; the integrals are sums of trapezia over
/// the samples from first touch.
///
/// After contact has ended, by the record, there is no force, and so nothing missing.
///
/// Caution: where the chain has filters, F is read later by their delay, and the law is sent
///          through them.
struct ForceSamples {
  double mass = 0.0;                  ///< [kg]
  double speed = 0.0;                 ///< v₀ [m/s]
  double gain = 1.0;                  ///< reading over force
  std::vector<double> since_touch;    ///< [s]
  std::vector<double> deflection;     ///< x [m]
  std::vector<double> velocity;       ///< v [m/s]
  std::vector<double> missing;        ///< y [N]
  std::vector<double> by_deflection;  ///< ∂F_law/∂x [N/m]
  std::vector<double> by_velocity;    ///< ∂F_law/∂v [N s/m]
  Loop loop;
  MeasurementChain filters;  ///< of the chain, those alone
  Trace law;                 ///< force of the law along the motion, from first touch
  std::size_t last = 0;      ///< sample with which contact ends

  /// Position on the loop; below zero before first touch and after separation.
  double position(std::size_t sample) const;
};

/// At these values of the fit's unknowns.
/// Errors: as JointModel::problem_at() and ComposedContact.
ForceSamples force_samples(const Observations& seen, const HypothesisFit& fit,
                           const std::vector<double>& values, std::size_t shot);

/// Samples next to the turning point: whether they still load, the speed's own error decides, and
/// a force that jumps there would decide it the other way. They are taken as not read.
std::vector<std::size_t> samples_at_turning(const ForceSamples& samples, double speed_error);

/// What a force on the ball does to its reading, to first order, column by column.
///
///   z = g + F_x δx + F_v δv,   m δv̇ = −z,   δẋ = δv
///
/// z of y itself is white where y is of noise alone: the noise of a sample moves the integrals of
/// all later ones, and z takes that out again.
/// Limit:   a steady force beside a spring -> test
/// ForceSamplesTest.ASpringAnswersASteadyForceByACosine.
void respond(const ForceSamples& samples, Eigen::Ref<Eigen::MatrixXd> columns);

/// Sends columns through the filters of the chain.
void filter_columns(const ForceSamples& samples, Eigen::Ref<Eigen::MatrixXd> columns);

}  // namespace rebound
