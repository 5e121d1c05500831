#include "lumped/integration/sample_instants.hpp"

#include <cmath>

namespace rebound {
namespace {

constexpr std::size_t intervals = 4;  // at each end
constexpr std::size_t parts = 24;     // of them

/// In even intervals from the end.
double place_of(std::size_t part) {
  return double(intervals) * std::pow(double(part) / double(parts), 3);
}

}  // namespace

std::size_t sample_count(const LumpedControls& controls) {
  const auto even = static_cast<std::size_t>(controls.samples);
  return controls.finer_ends ? even + 2 * (parts - intervals) : even;
}

void fill_sample_instants(double contact_time, const LumpedControls& controls,
                          std::span<double> time) {
  const auto last_even = static_cast<std::size_t>(controls.samples) - 1;
  const auto even = [&](std::size_t i) {
    return contact_time * static_cast<double>(i) / static_cast<double>(last_even);
  };
  const std::size_t last = time.size() - 1, added = parts - intervals;
  if (!controls.finer_ends) {
    for (std::size_t i = 0; i <= last; ++i) time[i] = even(i);
  } else {
    const double step = even(1);
    for (std::size_t part = 0; part < parts; ++part) {
      time[part] = step * place_of(part);
      time[last - part] = contact_time - step * place_of(part);
    }
    for (std::size_t i = parts; i + parts <= last; ++i) time[i] = even(i - added);
  }
  time[last] = contact_time;
}

}  // namespace rebound
