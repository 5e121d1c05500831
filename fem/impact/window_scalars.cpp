#include "fem/impact/window_scalars.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/scalars.hpp"

namespace rebound::fem {
namespace {

std::vector<double> even_grid(double spacing, std::size_t count) {
  std::vector<double> time;
  for (std::size_t k = 0; k < count; ++k) time.push_back(spacing * static_cast<double>(k));
  return time;
}

}  // namespace

double tail_contact_time(const std::vector<double>& time, const std::vector<double>& force,
                         double peak, double separation_time) {
  constexpr double from = 0.15, to = 0.02;
  std::size_t begin = force.size();
  while (begin > 0 && force[begin - 1] < from * peak) --begin;
  std::size_t end = begin;
  while (end < force.size() && force[end] >= to * peak) ++end;
  if (end - begin < 3) return separation_time;
  double t_mean = 0.0, y_mean = 0.0;
  const auto count = static_cast<double>(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    t_mean += time[i] / count;
    y_mean += std::pow(force[i], 2.0 / 3.0) / count;
  }
  double covariance = 0.0, variance = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    covariance += (time[i] - t_mean) * (std::pow(force[i], 2.0 / 3.0) - y_mean);
    variance += (time[i] - t_mean) * (time[i] - t_mean);
  }
  return covariance < 0.0 ? t_mean - y_mean * variance / covariance : separation_time;
}

WindowScalars window_scalars(const ImpulseBins& half_windows, double separation_time) {
  const std::vector<double> sliding = half_windows.running_means(4);
  const std::vector<double> slid_by = even_grid(0.5 * half_windows.interval(), sliding.size());
  const std::vector<double> force = half_windows.force(half_windows.filled());
  const std::vector<double> time = even_grid(half_windows.interval(), force.size());
  WindowScalars scalars{.peak_force = refined_peak(slid_by, sliding)};
  scalars.contact_time_1pct = time_above(time, force, 0.01 * scalars.peak_force);
  scalars.contact_time_tail = tail_contact_time(time, force, scalars.peak_force, separation_time);
  return scalars;
}

}  // namespace rebound::fem
