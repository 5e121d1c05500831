#include "comparisons/studies/reproduce/interval.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

bool overlap(const Interval& one, const Interval& other) {
  return one.low <= other.high && other.low <= one.high;
}

Interval rounding_interval(const PrintedNumber& number) {
  return {number.value - number.half_width, number.value + number.half_width};
}

PrintedNumber exactly(double value) {
  return {.value = value, .half_width = 0.0};
}

Interval corner_range(const Formula& formula, const std::vector<PrintedNumber>& inputs) {
  std::vector<std::size_t> wide;
  std::vector<double> values;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    values.push_back(inputs[i].value);
    if (inputs[i].half_width > 0.0) wide.push_back(i);
  }
  const double nominal = formula(values);
  Interval range{nominal, nominal};
  for (std::size_t corner = 0; corner < (std::size_t{1} << wide.size()) && !wide.empty();
       ++corner) {
    for (std::size_t bit = 0; bit < wide.size(); ++bit) {
      const PrintedNumber& input = inputs[wide[bit]];
      const bool upper = (corner >> bit) & 1U;
      values[wide[bit]] = input.value + (upper ? input.half_width : -input.half_width);
    }
    const double value = formula(values);
    range = {std::min(range.low, value), std::max(range.high, value)};
  }
  return range;
}

Interval magnitude(const Interval& interval) {
  if (interval.low >= 0.0) return interval;
  if (interval.high <= 0.0) return {-interval.high, -interval.low};
  return {0.0, std::max(-interval.low, interval.high)};
}

Interval mean_of(const std::vector<Interval>& intervals) {
  Interval sum;
  for (const Interval& interval : intervals) {
    sum.low += interval.low;
    sum.high += interval.high;
  }
  const auto count = static_cast<double>(intervals.size());
  return {sum.low / count, sum.high / count};
}

Interval largest_of(const std::vector<Interval>& intervals) {
  Interval largest = intervals.front();
  for (const Interval& interval : intervals)
    largest = {std::max(largest.low, interval.low), std::max(largest.high, interval.high)};
  return largest;
}

}  // namespace rebound
