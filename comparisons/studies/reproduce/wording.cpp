#include "comparisons/studies/reproduce/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rebound {

std::string listed(const std::vector<double>& values, int decimals) {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{:.{}f}", text.empty() ? "" : "/", value, decimals);
  return text;
}

std::string listed_by_core(const Paper& paper, const std::vector<std::vector<double>>& values,
                           int decimals) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", paper.cores[i].name,
                        listed(values[i], decimals));
  return text;
}

std::string ranged(const Interval& interval, int decimals) {
  return fmt::format("{:.{}f} to {:.{}f}", interval.low, decimals, interval.high, decimals);
}

Interval extent_of(const std::vector<std::vector<double>>& values) {
  Interval extent{values.front().front(), values.front().front()};
  for (const auto& row : values)
    for (const double value : row)
      extent = {std::min(extent.low, value), std::max(extent.high, value)};
  return extent;
}

double logarithmic_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    products += dx * (std::log(y[i]) - mean_y);
    squares += dx * dx;
  }
  return products / squares;
}

}  // namespace rebound
