#include "comparisons/discrepancy/diagnosis/missing_force/first_touch.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

FirstTouch first_touch_of(const MeasuredImpact& measured, double baseline, double contact_time) {
  constexpr double lowest = 3.0, highest = 0.2;  // of the noise, of the peak
  constexpr double systematic = 0.03;            // of the contact time
  const std::vector<double>& force = measured.trace.force;
  const auto top = std::max_element(force.begin(), force.end()) - force.begin();
  const double peak = force[static_cast<std::size_t>(top)] - baseline;
  const double noise = measured.noise.deviation;
  const double low = std::min(lowest * noise, 0.5 * highest * peak);
  // Weighted regression of t on F^{2/3}, from the last sample below the upper limit downwards.
  double s = 0.0, sx = 0.0, st = 0.0, sxx = 0.0, sxt = 0.0;
  auto i = static_cast<std::size_t>(top);
  while (i > 0 && force[i] - baseline > highest * peak) --i;
  const std::size_t upper = i;
  for (;; --i) {
    const double f = force[i] - baseline;
    if (f < low) break;
    const double x = std::cbrt(f * f);
    const double weight = std::cbrt(f * f);  // F^{2/3} is known to 2/3 F^{-1/3} σ
    s += weight;
    sx += weight * x;
    st += weight * measured.trace.time[i];
    sxx += weight * x * x;
    sxt += weight * x * measured.trace.time[i];
    if (i == 0) break;
  }
  const double determinant = s * sxx - sx * sx;
  const double step = measured.trace.time[1] - measured.trace.time[0];
  if (!(determinant > 0.0))
    return {measured.trace.time[upper], std::max(step, 0.02 * contact_time)};
  const double slope = (s * sxt - sx * st) / determinant;  // dt/dF^{2/3}
  const double time = (st - slope * sx) / s;
  const double scatter = 2.0 / 3.0 * noise * slope * std::sqrt(sxx / determinant);
  return {time, std::hypot(systematic * contact_time, scatter)};
}

}  // namespace rebound
