#include "comparisons/models/instrument/channel_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

struct Coefficients {
  double a0, a1, a2, b1, b2;
};

Coefficients coefficients_of(double channel_class, double interval) {
  constexpr double design_factor = 2.0775;  // Appendix C: the corner of one pass
  const double designed = 2.0 * std::numbers::pi * design_factor * channel_class;
  const double w = std::tan(0.5 * designed * interval);
  const double d = 1.0 + std::numbers::sqrt2 * w + w * w;
  return {w * w / d, 2.0 * w * w / d, w * w / d, -2.0 * (w * w - 1.0) / d,
          (-1.0 + std::numbers::sqrt2 * w - w * w) / d};
}

/// One pass, as if the signal had stood at `rest` for ever.
void pass(const Coefficients& c, double rest, std::vector<double>& signal) {
  double x1 = rest, x2 = rest, y1 = rest, y2 = rest;
  for (double& value : signal) {
    const double x = value;
    value = c.a0 * x + c.a1 * x1 + c.a2 * x2 + c.b1 * y1 + c.b2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = value;
  }
}

double mean_of_first(const std::vector<double>& signal) {
  const auto count = std::min<std::ptrdiff_t>(10, std::ssize(signal));
  return std::accumulate(signal.begin(), signal.begin() + count, 0.0) / static_cast<double>(count);
}

}  // namespace

double class_corner(double channel_class) {
  // Two poles at 2.0775 CFC pass 1/2 of the power twice: −3 dB of both lie lower by (√2 − 1)^(1/4).
  return 2.0775 * channel_class * std::pow(std::numbers::sqrt2 - 1.0, 0.25);
}

std::vector<double> channel_filtered(const std::vector<double>& signal, double interval,
                                     double channel_class) {
  if (!(interval * 10.0 * channel_class <= 1.0 + 1e-9))
    throw Error(ExitCode::bad_input,
                fmt::format("a filter of class {:g} needs {:g} samples a second", channel_class,
                            10.0 * channel_class),
                {.value = fmt::format("{:.5g}", 1.0 / interval)});
  const Coefficients c = coefficients_of(channel_class, interval);
  std::vector<double> filtered = signal;
  // The tail is given room to die away, else the way back would start in the middle of it.
  const auto room = static_cast<std::size_t>(std::ceil(1.0 / (channel_class * interval)));
  std::reverse(filtered.begin(), filtered.end());
  const double end = mean_of_first(filtered);
  std::reverse(filtered.begin(), filtered.end());
  const double start = mean_of_first(filtered);
  filtered.insert(filtered.begin(), room, start);
  filtered.insert(filtered.end(), room, end);
  pass(c, start, filtered);
  std::reverse(filtered.begin(), filtered.end());
  pass(c, end, filtered);
  std::reverse(filtered.begin(), filtered.end());
  return {filtered.begin() + static_cast<std::ptrdiff_t>(room),
          filtered.end() - static_cast<std::ptrdiff_t>(room)};
}

}  // namespace rebound
