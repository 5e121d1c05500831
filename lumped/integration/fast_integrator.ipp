#pragma once

namespace rebound {

template <ContactLaw Law>
double FastIntegrator<Law>::error_norm(const Step& step, const ContactScales& scales) const {
  const double energy = 0.5 * setup_.mass * setup_.speed * setup_.speed;
  const double largest = std::max({std::abs(step.error[u]) / std::sqrt(scales.deflection),
                                   std::abs(step.error[v]) / setup_.speed,
                                   std::abs(step.error[t]) / scales.time,
                                   std::abs(step.error[dissipated]) / energy});
  return largest / setup_.relative_tolerance;
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
                                               double u_scale) const {
  const bool reaches_zero = step_of(y, slope, h).y[u] <= 0.0;
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
  return reaches_zero ? step_to_zero_deflection(y, slope, h, 0.0) : h;
}

template <ContactLaw Law>
const ContactEnd& FastIntegrator<Law>::integrate() {
  const ContactScales scales = contact_scales(law_, setup_);
  const double u_scale = std::sqrt(scales.deflection);
  Values y = {0.0, setup_.speed, 0.0, 0.0, 0.0};
  Values slope = field(y);
  double h = 0.3 * u_scale / setup_.speed * std::pow(setup_.relative_tolerance, 0.1);
  knots_ = 0;
  for (int attempt = 0; attempt < most_steps_; ++attempt) {
    Step step = step_of(y, slope, h);
    const double error = error_norm(step, scales);
    if (!std::isfinite(error)) {
      h *= 0.1;
      continue;
    }
    if (error <= 1.0) {
      const bool last = separated(step.y);
      if (last) {
        h = step_to_separation(y, slope, h, u_scale);
        step = step_of(y, slope, h);
      }
      keep(y, slope, h);
      y = step.y;
      slope = step.derivative;
      if (last) {
        keep(y, slope, 0.0);
        end_ = {y[t], y[u] * std::abs(y[u]), y[v], y[impulse], y[dissipated]};
        return end_;
      }
      if (y[t] > longest_contact * scales.time) throw contact_does_not_end();
    }
    h *= std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0);
  }
  throw Error(ExitCode::solver_failed,
              "the fast integrator ran out of steps: the contact is too strongly damped for an "
              "explicit method, or the tolerance too small");
}

template <ContactLaw Law>
void FastIntegrator<Law>::sample(const SampleView& samples) const {
  const std::size_t last = samples.time.size() - 1;
  const auto end_of = [&](const Knot& k) {
    return std::pair{HermiteEnd{k.u, k.v, k.acceleration}, HermiteEnd{k.t, 2.0 * k.u, 2.0 * k.v}};
  };
  std::size_t i = 0;
  for (int k = 0; k + 1 < knots_; ++k) {
    const Knot &left = knot_[k], &right = knot_[k + 1];
    const auto [u_left, t_left] = end_of(left);
    const auto [u_right, t_right] = end_of(right);
    const Quintic root(u_left, u_right, left.step), clock(t_left, t_right, left.step);
    const double duration = right.t - left.t;
    // Time runs as a parabola of θ where u passes zero: from such an end the
    // square root starts Newton on the right side.
    const bool from_rest = left.u < 0.5 * right.u, to_rest = right.u < 0.5 * left.u;
    for (; i < last; ++i) {
      const double instant = end_.time * static_cast<double>(i) / static_cast<double>(last);
      if (instant >= right.t) break;
      const double fraction = (instant - left.t) / duration;
      double s = from_rest ? std::sqrt(fraction)
                 : to_rest ? 1.0 - std::sqrt(1.0 - fraction)
                           : fraction;
      for (int iteration = 0; iteration < 20; ++iteration) {
        const double rate = clock.derivative(s);
        if (!(rate > 0.0)) break;  // at a point of rest: s is already exact
        const double change = (instant - clock.value(s)) / rate;
        s = std::clamp(s + change, 0.0, 1.0);
        if (std::abs(change) < 1e-11) break;
      }
      const double u_at = root.value(s);
      samples.time[i] = instant;
      samples.deflection[i] = u_at * u_at;
      samples.force[i] = law_.force(u_at * u_at, root.derivative(s) / left.step);
    }
  }
  samples.time[last] = end_.time;
  samples.deflection[last] = end_.deflection;
  samples.force[last] = law_.force(end_.deflection, end_.velocity);
}

}  // namespace rebound
