#pragma once

namespace rebound {

template <ContactLaw Law>
void FastIntegrator<Law>::set_weights(const ContactScales& scales) {
  const double energy = 0.5 * setup_.mass * setup_.speed * setup_.speed;
  weight_ = {1.0 / std::sqrt(scales.deflection), 1.0 / setup_.speed, 1.0 / scales.time,
             1.0 / (setup_.mass * setup_.speed), 1.0 / energy};
  for (double& weight : weight_) weight /= setup_.relative_tolerance;
}

/// Largest local error over its tolerance; at most 1 in an accepted step.
template <ContactLaw Law>
double FastIntegrator<Law>::error_norm(const Step& step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < states; ++i) {
    const double error = std::abs(step.error[i]) * weight_[i];
    if (!(error <= largest)) largest = error;  // keeps a NaN
  }
  return largest;
}

template <ContactLaw Law>
void FastIntegrator<Law>::keep(const Values& y, const Values& slope, double step) {
  knot_[knots_++] = {y[u], y[v], slope[v], y[t], step};
}

/// Newton on the length of the step, du/dh = v: ends where u = u_end.
template <ContactLaw Law>
double FastIntegrator<Law>::step_to_zero_deflection(const Values& y, const Values& slope, double h,
                                                    double u_end) const {
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Values at = step_of(y, slope, h).y;
    const double change = (u_end - at[u]) / at[v];
    h += change;
    if (std::abs(change) <= 4e-16 * h) break;
  }
  return h;
}

/// Length of the last step, given that separation lies within h.
///
/// Laws whose force vanishes together with x (Hunt–Crossley) have a flat zero
/// there, so the force is asked for its sign just before x = 0; only where it
/// already pulls does a root of the force lie earlier.
template <ContactLaw Law>
double FastIntegrator<Law>::step_to_separation(const Values& y, const Values& slope, double h,
                                               double u_scale) {
  const bool reaches_zero = step_of(y, slope, h).y[u] <= 0.0;
  reached_zero_ = false;
  if (setup_.separation == SeparationRule::zero_force) {
    const double u_probe = std::min(1e-6 * u_scale, 0.5 * y[u]);
    const double before = reaches_zero ? step_to_zero_deflection(y, slope, h, u_probe) : h;
    if (force(step_of(y, slope, before).y) < 0.0) {
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          [&](double length) { return force(step_of(y, slope, length).y); }, 0.0, before,
          boost::math::tools::eps_tolerance<double>(50), iterations);
      return 0.5 * (bracket.first + bracket.second);
    }
  }
  reached_zero_ = reaches_zero;
  return reaches_zero ? step_to_zero_deflection(y, slope, h, 0.0) : h;
}

template <ContactLaw Law>
const ContactEnd& FastIntegrator<Law>::integrate() {
  const ContactScales scales = contact_scales(law_, setup_);
  const double u_scale = std::sqrt(scales.deflection);
  Values y = {0.0, setup_.speed, 0.0, 0.0, 0.0};
  Values slope = field(y);
  set_weights(scales);
  double h = 0.3 * u_scale / setup_.speed * std::pow(setup_.relative_tolerance, 0.1);
  knots_ = 0;
  for (int attempt = 0; attempt < most_steps_; ++attempt) {
    Step step = step_of(y, slope, h);
    const double error = error_norm(step);
    if (!std::isfinite(error)) {
      h *= 0.1;
      continue;
    }
    if (error <= 1.0) {
      const bool last = separated(step.y);
      if (last) {
        h = step_to_separation(y, slope, h, u_scale);
        step = step_of(y, slope, h);
        if (reached_zero_) step.y[u] = 0.0;  // what is left is rounding
      }
      keep(y, slope, h);
      y = step.y;
      slope = step.derivative;
      if (last) {
        keep(y, slope, 0.0);
        end_ = {y[t], y[u] * y[u], y[v], y[impulse], y[dissipated]};
        require_rebound(end_, setup_);
        return end_;
      }
      if (y[t] > longest_contact * scales.time) throw contact_does_not_end();
    }
    // Single precision is plenty for a step length, and three times as fast.
    h *= std::clamp(0.9f * std::pow(static_cast<float>(error), -0.2f), 0.2f, 5.0f);
  }
  throw Error(ExitCode::solver_failed,
              "the fast integrator ran out of steps: the contact is too strongly damped for an "
              "explicit method, or the tolerance too small");
}

/// Instants of one step in the middle of the contact: x is smooth in time
/// there and its own quintic serves. Returns the index after the last one.
template <ContactLaw Law>
std::size_t FastIntegrator<Law>::sample_in_time(const Knot& left, const Knot& right, std::size_t i,
                                                const SampleView& samples) const {
  const auto end_of = [](const Knot& k) {
    return HermiteEnd{k.u * k.u, k.v, k.acceleration / (2.0 * k.u)};
  };
  const double duration = right.t - left.t, inverse = 1.0 / duration;
  const Quintic path(end_of(left), end_of(right), duration);
  for (; i + 1 < samples.time.size() && instant(i, samples) < right.t; ++i) {
    const double s = (instant(i, samples) - left.t) * inverse;
    const double x = path.value(s);
    samples.deflection[i] = x;
    samples.force[i] = law_.force(x, path.derivative(s) * inverse);
  }
  return i;
}

/// Instants of one step near first touch or separation, where only u(τ) and
/// t(τ) are smooth: Newton inverts t(τ) = instant.
template <ContactLaw Law>
std::size_t FastIntegrator<Law>::sample_near_end(const Knot& left, const Knot& right,
                                                 std::size_t i, const SampleView& samples) const {
  const Quintic root(left.root(), right.root(), left.step);
  const Quintic clock(left.clock(), right.clock(), left.step);
  for (; i + 1 < samples.time.size() && instant(i, samples) < right.t; ++i) {
    const double target = instant(i, samples);
    const double fraction = (target - left.t) / (right.t - left.t);
    // Time runs as a parabola where u passes zero: the square root starts
    // Newton on the side from which it converges.
    double s = left.u < right.u ? std::sqrt(fraction) : 1.0 - std::sqrt(1.0 - fraction);
    for (int iteration = 0; iteration < 20; ++iteration) {
      const double rate = clock.derivative(s);
      if (!(rate > 0.0)) break;  // at rest in τ: s is the end itself
      const double change = (target - clock.value(s)) / rate;
      s = std::clamp(s + change, 0.0, 1.0);
      if (std::abs(change) < 1e-11) break;
    }
    const double u_at = root.value(s);
    samples.deflection[i] = u_at * u_at;
    samples.force[i] = law_.force(u_at * u_at, root.derivative(s) / left.step);
  }
  return i;
}

template <ContactLaw Law>
void FastIntegrator<Law>::sample(const SampleView& samples) const {
  const std::size_t last = samples.time.size() - 1;
  for (std::size_t i = 0; i < last; ++i) samples.time[i] = instant(i, samples);
  std::size_t i = 0;
  for (int k = 0; k + 1 < knots_; ++k) {
    const Knot &left = knot_[k], &right = knot_[k + 1];
    // u within a fifth across the step: its singular end is two steps away.
    const bool middle = left.u > 0.8 * right.u && right.u > 0.8 * left.u;
    i = middle ? sample_in_time(left, right, i, samples) : sample_near_end(left, right, i, samples);
  }
  samples.time[last] = end_.time;
  samples.deflection[last] = end_.deflection;
  samples.force[last] = law_.force(end_.deflection, end_.velocity);
}

}  // namespace rebound
