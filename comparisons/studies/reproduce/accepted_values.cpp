#include "comparisons/studies/reproduce/accepted_values.hpp"

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double reach = 8.0;
constexpr int grid_points = 241;

/// The row with one input set: published against computed as one signed number.
class InputGap {
 public:
  InputGap(const DerivedRow& row, std::size_t input, Strictness strictness)
      : row_(row), input_(input), inputs_(printed_inputs(row)) {
    if (strictness == Strictness::to_the_digit)
      for (PrintedNumber& number : inputs_) number.half_width = 0.0;
  }

  /// > 0: all that is computed is too large; < 0: too small; 0: it meets the
  /// published interval. Not a number where the formula refuses the value, as
  /// it does a restitution above 1.
  double operator()(double value) try {
    inputs_[input_] = exactly(value);
    const Interval computed = corner_range(row_.formula, inputs_);
    const Interval published = rounding_interval(row_.published);
    if (computed.low > published.high) return computed.low - published.high;
    if (computed.high < published.low) return computed.high - published.low;
    return overlap(computed, published) ? 0.0 : std::nan("");
  } catch (const Error&) {
    return std::nan("");
  }

  /// Between a value that is accepted (or not) and one that is not (or is):
  /// where that changes.
  double edge(double from, double to) {
    const bool accepted = (*this)(from) == 0.0;
    for (int step = 0; step < 100 && std::abs(to - from) > 1e-14 * std::abs(to); ++step) {
      const double middle = 0.5 * (from + to);
      (((*this)(middle) == 0.0) == accepted ? from : to) = middle;
    }
    return 0.5 * (from + to);
  }

  /// Between a value that is too small a result and one that is too large: an
  /// accepted value, or NaN where the result jumps over the published interval.
  double accepted_between(double from, double to) {
    const bool negative = (*this)(from) < 0.0;
    for (int step = 0; step < 100 && std::abs(to - from) > 1e-14 * std::abs(to); ++step) {
      const double middle = 0.5 * (from + to);
      const double gap = (*this)(middle);
      if (gap == 0.0) return middle;
      ((gap < 0.0) == negative ? from : to) = middle;
    }
    return std::nan("");
  }

 private:
  const DerivedRow& row_;
  std::size_t input_;
  std::vector<PrintedNumber> inputs_;
};

}  // namespace

std::vector<Interval> accepted_values(const DerivedRow& row, std::size_t input,
                                      Strictness strictness) {
  InputGap gap(row, input, strictness);
  const double printed = row.inputs[input].printed.value;
  const auto grid = [&](int i) {
    return printed * std::pow(reach, 2.0 * i / (grid_points - 1) - 1.0);
  };
  std::vector<Interval> accepted;
  double last = grid(0);
  double last_gap = gap(last);
  if (last_gap == 0.0) accepted.push_back({last, last});
  for (int i = 1; i < grid_points; ++i) {
    const double next = grid(i);
    const double next_gap = gap(next);
    if (last_gap == 0.0) {
      accepted.back().high = next_gap == 0.0 ? next : gap.edge(last, next);
    } else if (next_gap == 0.0) {
      accepted.push_back({gap.edge(last, next), next});
    } else if (last_gap * next_gap < 0.0) {
      const double inside = gap.accepted_between(last, next);
      if (!std::isnan(inside)) accepted.push_back({gap.edge(inside, last), gap.edge(inside, next)});
    }
    last = next;
    last_gap = next_gap;
  }
  return accepted;
}

}  // namespace rebound
