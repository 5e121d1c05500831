#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "lumped/integration/contact_scales.hpp"
#include "lumped/integration/direction.hpp"
#include "lumped/integration/fast/eighth_order_step.hpp"
#include "lumped/integration/fast/septic.hpp"
#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Where samples of a trace are written.
struct SampleView {
  std::span<const double> time;  ///< when [s]
  std::span<double> force;       ///< [N]
  std::span<double> deflection;  ///< [m]
};

/// State at one end of a step of FastIntegrator.
struct StepEnd {
  double u;             ///< √x [√m]
  double v;             ///< closing speed, dx/dt = du/dτ [m/s]
  double acceleration;  ///< dv/dτ [√m m/s²]
  double jerk;          ///< d²v/dτ² [m²/s³]
  double t;             ///< time [s]
  double step;          ///< to the next step_end, in τ [s/√m]

  HermiteEnd root() const { return {u, v, acceleration, jerk}; }                  ///< u(τ)
  HermiteEnd clock() const { return {t, 2.0 * u, 2.0 * v, 2.0 * acceleration}; }  ///< t(τ)
};

/// Integrates one impact in a few microseconds, compiled for the law, without
/// allocating; with `Width` > 0 also the derivatives of the motion in so many directions.
///
///   u = √x,  dt = 2u dτ:    u′ = v,   v′ = −2u F(u², v)/m,   t′ = 2u
///
///   x   deflection [m]    v = ẋ   closing speed [m/s]    τ   fictitious time [s/√m]
///
/// In x and t the fields of contact laws have square roots at first touch and
/// high-order steps lose their order there; in u and τ the fields of
/// Kelvin–Voigt, Kuwabara–Kono and Hunt–Crossley are polynomials, and steps of
/// eighth order cross a contact in about ten.
///
/// Derivatives by a parameter p follow the variational equations
///
///   δu′ = δv,   δv′ = −(2/m) [(F + 2x F_x) δu + u F_v δv + u F_p],   δt′ = 2 δu
///
/// through the same steps: what comes out is the derivative of the numbers computed, but for
/// the choice of the steps.
///
/// Separation is met by the last step itself, shortened until it ends there,
/// not by interpolation. Between the ends of steps the motion is a Hermite
/// polynomial of seventh degree.
///
/// Valid:   every law of the list without further states, both separation rules.
/// Limit:   same scalars as CVODE -> test IntegratorsTest.FastPathAgreesWithCvode;
///          exact Hunt–Crossley and Kelvin–Voigt -> test verification case h.
/// Caution: explicit: a contact damped so strongly that it becomes stiff runs
///          out of steps; simulate() takes those.
/// Errors:  Error(solver_failed) when the contact does not end or steps run out.
template <ContactLaw Law, std::size_t Width = 0>
class FastIntegrator {
 public:
  using Directions = std::array<Direction, Width>;
  using Row = std::array<double, Width>;  ///< one derivative a direction

  FastIntegrator(const Law& law, const ContactSetup& setup, const Directions& directions = {})
      : law_(law), setup_(setup), directions_(directions) {}

  const ContactEnd& integrate();

  /// Fills the samples at their instants, which increase from 0 to the contact time, both
  /// included. Call after integrate(); all columns of one size ≥ 2.
  void sample(const SampleView& samples) const;

  const ContactEnd& end() const { return end_; }

  /// Ends of the steps taken, from first touch to separation.
  std::span<const StepEnd> step_ends() const {
    return {step_ends_.data(), static_cast<std::size_t>(step_ends_count_)};
  }

  /// Derivatives at a step_end, at fixed τ.
  struct Variation {
    Row u, v, acceleration, t;

    /// δt(τ), whose slope is 2 δu and whose curvature is 2 δv.
    HermiteEnd clock(std::size_t i) const {
      return {t[i], 2.0 * u[i], 2.0 * v[i], 2.0 * acceleration[i]};
    }
  };
  std::span<const Variation> variations() const {
    return {variation_.data(), static_cast<std::size_t>(step_ends_count_)};
  }
  /// Did separation come at x = 0, or where the force turned to pull?
  bool ended_at_zero_deflection() const { return reached_zero_; }

 private:
  enum State { u, v, du };                         // then δu and δv of each direction
  enum Quadrature { t, impulse, dissipated, dt };  // then δt of each direction
  static constexpr std::size_t states = 2 + 2 * Width;
  static constexpr std::size_t dv = du + Width;
  using Step = EighthOrderStep<states, 3 + Width>;
  using Values = typename Step::State;
  using Slope = typename Step::Slope;

  [[gnu::always_inline]] Slope field(const Values& y) const;
  [[gnu::always_inline]] Step step_of(const Values& y, const Slope& slope, double h) const {
    Step step;
    step.take([this](const Values& at) { return field(at); }, y, slope, h);
    return step;
  }
  /// The state after a step, for the search of its end: compiled once, not at every call.
  [[gnu::noinline]] Values after_step(const Values& y, const Slope& slope, double h) const {
    return step_of(y, slope, h).y;
  }
  /// d²v/dτ².
  double jerk(double u_at, double v_at, double acceleration) const {
    const ForceSlopes f = law_.at_root(u_at, v_at);
    return -2.0 / setup_.mass *
           ((f.force + 2.0 * f.by_log_deflection) * v_at + u_at * f.by_speed * acceleration);
  }
  double force(double u_at, double v_at) const { return law_.at_root(u_at, v_at).force; }
  bool separated(const Values& y) const {
    if (y[u] <= 0.0) return true;
    return setup_.separation == SeparationRule::zero_force && y[v] < 0.0 &&
           force(y[u], y[v]) <= 0.0;
  }
  double step_just_beyond(const Values& y, const Slope& slope) const;
  void set_tolerances(const ContactScales& scales);
  double error_norm(const Step& step) const;
  double step_to_zero_deflection(const Values& y, const Slope& slope, double h, double u_end) const;
  double step_to_zero_force(const Values& y, const Slope& slope, double low, double high,
                            const Septic& path, double h) const;
  double step_to_separation(const Values& y, const Slope& slope, const Step& beyond, double h);
  void keep(const Values& y, double time, const Slope& slope, double step);
  void finish(const Step& step, const ContactEnd& before);
  void sample_directly(const StepEnd& left, const StepEnd& right, bool opening, std::size_t from,
                       std::size_t to, const SampleView& samples) const;
  void sample_near_end(const StepEnd& left, const StepEnd& right, std::size_t from, std::size_t to,
                       const SampleView& samples) const;

  static constexpr int most_steps_ = 2000;
  Law law_;
  ContactSetup setup_;
  Directions directions_;
  ContactEnd end_;
  Values weight_{};  ///< 1 / absolute tolerance of u and v
  double time_weight_ = 0.0;
  double u_scale_ = 0.0;
  double longest_step_ = 0.0;  ///< that a polynomial of seventh degree follows [s/√m]
  bool reached_zero_ = false;
  int step_ends_count_ = 0;
  // Left uninitialised: only the first step_ends_count_ are read.
  std::array<StepEnd, most_steps_ + 1> step_ends_;
  std::array<Variation, Width == 0 ? 1 : most_steps_ + 1> variation_;
};

}  // namespace rebound

#include "lumped/integration/fast/fast_integrator.ipp"
#include "lumped/integration/fast/fast_samples.ipp"
