#pragma once

// Samples of FastIntegrator at given instants.
//
// In w = √t up to the turning point and w = √(T − t) after it, u is as smooth as in τ, where
// x(t) itself has half-integer powers: u follows from one polynomial, without inverting t(τ).
namespace rebound {

/// u(w) at a step_end from its derivatives in τ; w runs as τ does, away from first touch.
///
///   u_w = v r,   r = dτ/dw = w/u,   r_w = (1 − v r²)/u,   r_ww = −(a r³ + 3 v r r_w)/u
inline HermiteEnd root_by_clock_root(const HermiteEnd& root, double w) {
  const auto [u, v, a, j] = root;
  if (u == 0.0) {
    const double r = 1.0 / std::sqrt(v);
    return {0.0, v * r, 0.0, 0.75 * j * r * r * r};
  }
  const double r = w / u, r_w = (1.0 - v * r * r) / u, r_ww = -(a * r * r + 3.0 * v * r_w) * r / u;
  return {u, v * r, a * r * r + v * r_w, j * r * r * r + 3.0 * a * r * r_w + v * r_ww};
}

template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::sample_directly(const StepEnd& left, const StepEnd& right,
                                                 bool opening, std::size_t from, std::size_t to,
                                                 const SampleView& samples) const {
  const double origin = opening ? end_.time : 0.0, sign = opening ? -1.0 : 1.0;
  const auto distance = [&](double time) {
    return std::sqrt(std::max(0.0, sign * (time - origin)));
  };
  const auto end_of = [&](const StepEnd& k) {
    const HermiteEnd root{k.u, sign * k.v, k.acceleration, sign * k.jerk};
    return root_by_clock_root(root, distance(k.t));
  };
  const double start = distance(left.t), width = distance(right.t) - start;
  const Septic path(end_of(left), end_of(right), width);
  const double inverse = 1.0 / width;
  double* const force_at = samples.force.data();
  double* const deflection_at = samples.deflection.data();
  const double* const time_at = samples.time.data();
  // By value: no store into the columns can then change the law.
  const auto fill = [=](const auto law) {
    for (std::size_t i = from; i < to; ++i) {
      const double w = std::sqrt(std::abs(time_at[i] - origin)), s = (w - start) * inverse;
      const double root = path.value(s);
      deflection_at[i] = root * root;
      force_at[i] = law.at_root(root, sign * path.derivative(s) * inverse * root / w).force;
    }
  };
  if constexpr (requires { typename Law::Hertz; })
    if (law_.power.hertz()) return fill(typename Law::Hertz{law_});
  fill(law_);
}

/// Where u is smooth in τ only, as in a contact that ends shortly before x = 0: Newton inverts
/// t(τ) = instant.
template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::sample_near_end(const StepEnd& left, const StepEnd& right,
                                                 std::size_t from, std::size_t to,
                                                 const SampleView& samples) const {
  const Septic root(left.root(), right.root(), left.step);
  const Septic clock(left.clock(), right.clock(), left.step);
  for (std::size_t i = from; i < to; ++i) {
    const double target = samples.time[i];
    // Time runs as a parabola where u passes zero: the square root starts
    // Newton on the side from which it converges.
    double s = 1.0 - std::sqrt(std::max(0.0, (right.t - target) / (right.t - left.t)));
    for (int iteration = 0; iteration < 20; ++iteration) {
      const double rate = clock.derivative(s);
      if (!(rate > 0.0)) break;  // at rest in τ: s is the end itself
      const double change = (target - clock.value(s)) / rate;
      s = std::clamp(s + change, 0.0, 1.0);
      if (std::abs(change) < 1e-11) break;
    }
    const double u_at = root.value(s);
    samples.deflection[i] = u_at * u_at;
    samples.force[i] = force(u_at, root.derivative(s) / left.step);
  }
}

template <ContactLaw Law, std::size_t Width>
void FastIntegrator<Law, Width>::sample(const SampleView& samples) const {
  const std::size_t last = samples.time.size() - 1;
  // T − t of a step_end shortly before the end has lost digits, and u_ww two powers of u more.
  const double clear = 2.0 * u_scale_ * std::pow(1e-16 / setup_.relative_tolerance, 0.25);
  samples.deflection[0] = 0.0;
  samples.force[0] = force(0.0, setup_.speed);
  std::size_t from = 1;
  for (int k = 0; k + 1 < step_ends_count_ && from < last; ++k) {
    const StepEnd &left = step_ends_[k], &right = step_ends_[k + 1];
    std::size_t to = last;
    if (k + 2 < step_ends_count_) {
      const auto first = samples.time.begin();
      to = static_cast<std::size_t>(std::upper_bound(first + static_cast<std::ptrdiff_t>(from),
                                                     first + static_cast<std::ptrdiff_t>(last),
                                                     right.t) -
                                    first);
    }
    const bool opening = left.v <= 0.0 || k + 2 == step_ends_count_;
    const bool blurred = left.u < clear || (right.u > 0.0 && right.u < clear);
    if (opening && (blurred || end_.deflection > 0.0))
      sample_near_end(left, right, from, to, samples);
    else
      sample_directly(left, right, opening, from, to, samples);
    from = to;
  }
  samples.deflection[last] = end_.deflection;
  samples.force[last] = law_.force(end_.deflection, end_.velocity);
}

}  // namespace rebound
