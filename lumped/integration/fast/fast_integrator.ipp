#pragma once

namespace rebound {

template <ContactLaw Law, std::size_t Width>
inline typename FastIntegrator<Law, Width>::Slope FastIntegrator<Law, Width>::field(
    const Values& y) const {
  const ForceSlopes f = law_.at_root(y[u], y[v]);
  const double rate = 2.0 * y[u];  // dt/dτ
  const double per_mass = -2.0 / setup_.mass;
  Slope slope;
  slope.state[u] = y[v];
  slope.state[v] = per_mass * y[u] * f.force;
  slope.quadrature[t] = rate;
  slope.quadrature[impulse] = rate * f.force;
  slope.quadrature[dissipated] = rate * f.damping * y[v];
  if constexpr (Width > 0) {
    const double by_u = per_mass * (f.force + 2.0 * f.by_log_deflection);
    const double by_v = per_mass * y[u] * f.by_speed;
    for (std::size_t i = 0; i < Width; ++i) {
      double forced = 0.0;
      if (directions_[i].of == Direction::Of::law)
        forced = per_mass * y[u] * law_.slope_by(directions_[i].parameter, y[u], y[v]);
      else if (directions_[i].of == Direction::Of::mass)
        forced = -slope.state[v] / setup_.mass;
      slope.state[du + i] = y[dv + i];
      slope.state[dv + i] = by_u * y[du + i] + by_v * y[dv + i] + forced;
      slope.quadrature[dt + i] = 2.0 * y[du + i];
    }
  }
  return slope;
}

template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::set_tolerances(const ContactScales& scales) {
  const double tolerance = setup_.relative_tolerance;
  u_scale_ = std::sqrt(scales.deflection);
  weight_[u] = 1.0 / (tolerance * u_scale_);
  weight_[v] = 1.0 / (tolerance * setup_.speed);
  time_weight_ = 1.0 / (tolerance * scales.time);
  // The speed between step_ends is wrong by 1.8 % of h⁷ u⁽⁸⁾/7!; a sine's share is put in.
  longest_step_ =
      0.6 * u_scale_ / setup_.speed * std::pow(std::min(1.0, 1e6 * tolerance), 1.0 / 7.0);
}

/// Local error over its tolerance; at most 1 in an accepted step.
template <ContactLaw Law, std::size_t Width>
double FastIntegrator<Law, Width>::error_norm(const Step& step) const {
  const double five[] = {step.error5[u] * weight_[u], step.error5[v] * weight_[v],
                         step.gained_error5[t] * time_weight_};
  const double three[] = {step.error3[u] * weight_[u], step.error3[v] * weight_[v],
                          step.gained_error3[t] * time_weight_};
  double square5 = 0.0, square3 = 0.0;
  for (int i = 0; i < 3; ++i) {
    square5 += five[i] * five[i];
    square3 += three[i] * three[i];
  }
  const double both = square5 + 0.01 * square3;
  return both == 0.0 ? 0.0 : square5 / std::sqrt(both);
}

template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::keep(const Values& y, double time, const Slope& slope,
                                      double step) {
  if constexpr (Width > 0)
    for (std::size_t i = 0; i < Width; ++i) {
      variation_[step_ends_count_].u[i] = y[du + i];
      variation_[step_ends_count_].v[i] = y[dv + i];
      variation_[step_ends_count_].acceleration[i] = slope.state[dv + i];
    }
  step_ends_[step_ends_count_++] = {y[u], y[v], slope.state[v], jerk(y[u], y[v], slope.state[v]),
                                    time, step};
}

/// Newton on the length of the step, du/dh = v: ends where u = u_end.
template <ContactLaw Law, std::size_t Width>
double FastIntegrator<Law, Width>::step_to_zero_deflection(const Values& y, const Slope& slope,
                                                           double h, double u_end) const {
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Values at = after_step(y, slope, h);
    const double change = (u_end - at[u]) / at[v];
    h += change;
    // The next change would be about its square.
    if (std::abs(change) <= 1e-9 * h) break;
  }
  return h;
}

/// Length of the step that ends where the force is zero, which lies between
/// `low` and `high`: first on the polynomial, then by Newton on the step itself.
template <ContactLaw Law, std::size_t Width>
double FastIntegrator<Law, Width>::step_to_zero_force(const Values& y, const Slope& slope,
                                                      double low, double high, const Septic& path,
                                                      double h) const {
  const auto bracketed = [](const auto& f, double a, double b, int bits) {
    std::uintmax_t iterations = 100;
    const double fa = f(a), fb = f(b);
    if (fa * fb >= 0.0) return std::abs(fa) < std::abs(fb) ? a : b;
    const auto found = boost::math::tools::toms748_solve(
        f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(bits), iterations);
    return 0.5 * (found.first + found.second);
  };
  const auto along = [&](double s) { return force(path.value(s), path.derivative(s) / h); };
  double length = h * bracketed(along, low / h, high / h, 20);
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Values at = after_step(y, slope, length);
    const ForceSlopes f = law_.at_root(at[u], at[v]);
    const double acceleration = -2.0 / setup_.mass * at[u] * f.force;
    const double change =
        -f.force / (2.0 * f.by_log_deflection * at[v] / at[u] + f.by_speed * acceleration);
    if (!(length + change > low) || !(length + change < high)) break;
    length += change;
    if (std::abs(change) <= 1e-9 * length) return length;
  }
  return bracketed(
      [&](double at) {
        const Values end = after_step(y, slope, at);
        return force(end[u], end[v]);
      },
      low, high, 50);
}

/// Length of the last step, given that separation lies within h.
///
/// Laws whose force vanishes together with x (Hunt–Crossley) have a flat zero
/// there, so the force is asked for its sign just before x = 0; only where it
/// already pulls does a root of the force lie earlier.
template <ContactLaw Law, std::size_t Width>
double FastIntegrator<Law, Width>::step_to_separation(const Values& y, const Slope& slope,
                                                      const Step& beyond, double h) {
  const Slope after = field(beyond.y);
  const Septic path(HermiteEnd{y[u], y[v], slope.state[v], jerk(y[u], y[v], slope.state[v])},
                    HermiteEnd{beyond.y[u], beyond.y[v], after.state[v],
                               jerk(beyond.y[u], beyond.y[v], after.state[v])},
                    h);
  // On the polynomial, from where u was last known to be positive.
  const auto reach = [&](double u_end) {
    double s = (y[u] - u_end) / (y[u] - beyond.y[u]);
    for (int i = 0; i < 30; ++i) {
      const double change = (u_end - path.value(s)) / path.derivative(s);
      s = std::clamp(s + change, 0.0, 1.0);
      if (std::abs(change) < 1e-12) break;
    }
    return s * h;
  };
  const bool reaches_zero = beyond.y[u] <= 0.0;
  reached_zero_ = false;
  if (setup_.separation == SeparationRule::zero_force) {
    const double u_probe = std::min(1e-6 * u_scale_, 0.5 * y[u]);
    const double before =
        reaches_zero ? step_to_zero_deflection(y, slope, reach(u_probe), u_probe) : h;
    const Values at = after_step(y, slope, before);
    if (force(at[u], at[v]) < 0.0) return step_to_zero_force(y, slope, 0.0, before, path, h);
  }
  reached_zero_ = reaches_zero;
  return reaches_zero ? step_to_zero_deflection(y, slope, reach(0.0), 0.0) : h;
}

/// Step that ends a little beyond x = 0, where the field has another analytic form: no step
/// goes far into it. Where the force pulls, by the parabola; else x = 0 comes earlier than
/// at the present speed.
template <ContactLaw Law, std::size_t Width>
double FastIntegrator<Law, Width>::step_just_beyond(const Values& y, const Slope& slope) const {
  const double pull = std::max(0.0, 2.0 * y[u] * slope.state[v]);
  const double speed = std::sqrt(std::max(0.0, y[v] * y[v] - pull));
  return 1.05 * 2.0 * y[u] / (speed - y[v]);
}

template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::finish(const Step& step, const ContactEnd& before) {
  end_ = {before.time + step.gained[t], step.y[u] * step.y[u], step.y[v],
          before.impulse + step.gained[impulse], before.dissipated + step.gained[dissipated]};
}

template <ContactLaw Law, std::size_t Width>
const ContactEnd& FastIntegrator<Law, Width>::integrate() {
  const ContactScales scales = contact_scales(law_, setup_);
  set_tolerances(scales);
  Values y{};
  y[v] = setup_.speed;
  if constexpr (Width > 0)
    for (std::size_t i = 0; i < Width; ++i)
      if (directions_[i].of == Direction::Of::speed) y[dv + i] = 1.0;
  Slope slope = field(y);
  std::array<double, Width> time_variation{};
  end_ = {};
  step_ends_count_ = 0;
  double h = std::min(longest_step_,
                      0.6 * u_scale_ / setup_.speed * std::pow(setup_.relative_tolerance, 0.06));
  for (int attempt = 0; attempt < most_steps_; ++attempt) {
    if (y[v] < 0.0) h = std::min(h, step_just_beyond(y, slope));
    Step step = step_of(y, slope, h);
    const double error = error_norm(step);
    if (!std::isfinite(error)) {
      h *= 0.1;
      continue;
    }
    if (error <= 1.0) {
      const bool last = separated(step.y);
      if (last) {
        h = step_to_separation(y, slope, step, h);
        step = step_of(y, slope, h);
        if (reached_zero_) step.y[u] = 0.0;  // what is left is rounding
      }
      if constexpr (Width > 0) variation_[step_ends_count_].t = time_variation;
      keep(y, end_.time, slope, h);
      finish(step, end_);
      if constexpr (Width > 0)
        for (std::size_t i = 0; i < Width; ++i) time_variation[i] += step.gained[dt + i];
      y = step.y;
      slope = field(y);
      if (last) {
        if constexpr (Width > 0) variation_[step_ends_count_].t = time_variation;
        keep(y, end_.time, slope, 0.0);
        require_rebound(end_, setup_);
        return end_;
      }
      if (end_.time > longest_contact * scales.time) throw contact_does_not_end();
    }
    // Single precision is plenty for a step length, and faster.
    h *= std::clamp(0.9f * std::pow(static_cast<float>(error), -0.125f), 0.2f, 5.0f);
    h = std::min(h, longest_step_);
  }
  throw Error(ExitCode::solver_failed,
              "the fast integrator ran out of steps: the contact is too strongly damped for an "
              "explicit method, or the tolerance too small");
}

}  // namespace rebound
