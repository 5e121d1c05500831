#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "lumped/integration/contact_scales.hpp"
#include "lumped/integration/dormand_prince.hpp"
#include "lumped/integration/quintic.hpp"
#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// Where samples of a trace are written.
struct SampleView {
  std::span<double> time;        ///< [s]
  std::span<double> force;       ///< [N]
  std::span<double> deflection;  ///< [m]
};

/// State at one end of a step of FastIntegrator.
struct Knot {
  double u;             ///< √x [√m]
  double v;             ///< closing speed, dx/dt = du/dτ [m/s]
  double acceleration;  ///< dv/dτ [√m m/s²]
  double t;             ///< time [s]
  double step;          ///< to the next knot, in τ [s/√m]

  HermiteEnd root() const { return {u, v, acceleration}; }     ///< u(τ)
  HermiteEnd clock() const { return {t, 2.0 * u, 2.0 * v}; }   ///< t(τ)
};

/// Integrates one impact in a few microseconds, compiled for the law, without
/// allocating.
///
///   u = √x,  dt = 2u dτ:    u′ = v,   v′ = −2u F(u², v)/m,   t′ = 2u
///
///   x   deflection [m]    v = ẋ   closing speed [m/s]    τ   fictitious time [s/√m]
///
/// In x and t the fields of contact laws have square roots at first touch and
/// high-order steps lose their order there; in u and τ the fields of
/// Kelvin–Voigt, Kuwabara–Kono and Hunt–Crossley are polynomials.
///
/// Separation is met by the last step itself, shortened until it ends there,
/// not by interpolation. Samples come from quintic Hermite polynomials, in time
/// in the middle of the contact and in τ near its ends.
///
/// Valid:   every law of the list, both separation rules.
/// Limit:   same scalars as CVODE -> test IntegratorsTest.FastPathAgreesWithCvode;
///          exact Hunt–Crossley and Kelvin–Voigt -> test verification rung h.
/// Caution: explicit: a contact damped so strongly that it becomes stiff runs
///          out of steps; simulate() takes those.
/// Errors:  Error(solver_failed) when the contact does not end or steps run out.
template <ContactLaw Law>
class FastIntegrator {
 public:
  FastIntegrator(const Law& law, const ContactSetup& setup) : law_(law), setup_(setup) {}

  const ContactEnd& integrate();

  /// Fills the samples: equally spaced instants of [0, contact time], both
  /// ends included. Call after integrate(); all columns of one size ≥ 2.
  void sample(const SampleView& samples) const;

  const ContactEnd& end() const { return end_; }

  /// Ends of the steps taken, from first touch to separation.
  std::span<const Knot> knots() const { return {knot_.data(), static_cast<std::size_t>(knots_)}; }

 private:
  enum State { u, v, t, impulse, dissipated, states };
  using Step = DormandPrinceStep<states>;
  using Values = typename Step::State;

  Values field(const Values& y) const {
    const double x = y[u] * std::abs(y[u]);
    const double f = law_.force(x, y[v]);
    const double rate = 2.0 * y[u];  // dt/dτ
    return {y[v], -rate * f / setup_.mass, rate, rate * f,
            rate * law_.damping_force(x, y[v]) * y[v]};
  }
  Step step_of(const Values& y, const Values& slope, double h) const {
    Step step;
    step.take([this](const Values& at) { return field(at); }, y, slope, h);
    return step;
  }
  double force(const Values& y) const { return law_.force(y[u] * std::abs(y[u]), y[v]); }
  bool separated(const Values& y) const {
    if (y[u] <= 0.0) return true;
    return setup_.separation == SeparationRule::zero_force && y[v] < 0.0 && force(y) <= 0.0;
  }
  void set_weights(const ContactScales& scales);
  double error_norm(const Step& step) const;
  double step_to_zero_deflection(const Values& y, const Values& slope, double h,
                                 double u_end) const;
  double step_to_separation(const Values& y, const Values& slope, double h, double u_scale);
  void keep(const Values& y, const Values& slope, double step);
  double instant(std::size_t i, const SampleView& samples) const {
    return end_.time * static_cast<double>(i) / static_cast<double>(samples.time.size() - 1);
  }
  std::size_t sample_in_time(const Knot& left, const Knot& right, std::size_t i,
                             const SampleView& samples) const;
  std::size_t sample_near_end(const Knot& left, const Knot& right, std::size_t i,
                              const SampleView& samples) const;

  static constexpr int most_steps_ = 2000;
  Law law_;
  ContactSetup setup_;
  ContactEnd end_;
  Values weight_{};  ///< 1 / absolute tolerance of each state
  bool reached_zero_ = false;
  int knots_ = 0;
  std::array<Knot, most_steps_ + 1> knot_;  // left uninitialised: only the first knots_ are read
};

}  // namespace rebound

#include "lumped/integration/fast_integrator.ipp"
