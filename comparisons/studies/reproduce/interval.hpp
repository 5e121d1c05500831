#pragma once

#include <functional>
#include <vector>

#include "comparisons/io/dataset/published_values.hpp"

namespace rebound {

/// All values from `low` to `high`, both included.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  double middle() const { return 0.5 * (low + high); }
};

bool overlap(const Interval& one, const Interval& other);

/// Every value that would have been printed as this number was.
Interval rounding_interval(const PrintedNumber& number);

/// A number that was chosen, not rounded (a nominal speed, an assumed
/// Poisson's ratio): no width.
PrintedNumber exactly(double value);

/// A formula of printed inputs, in the order of those inputs.
using Formula = std::function<double(const std::vector<double>&)>;

/// What the formula gives over all inputs within their rounding intervals,
/// from its values at the 2^k corners of that box (k inputs that have a width).
///
/// Exact:   where the formula is monotone in each input on the box, all others
///          held -> test IntervalTest.CornersAreExactForMonotoneFormulas.
///          An input that enters twice is still one input: no width is lost
///          to treating its two places as independent.
/// Caution: for a formula that turns inside the box the range is too narrow.
///          Errors of models are therefore taken as ranges of the signed
///          difference first, then folded by magnitude().
Interval corner_range(const Formula& formula, const std::vector<PrintedNumber>& inputs);

/// |x| over the interval: its lower end is 0 where the interval holds 0.
Interval magnitude(const Interval& interval);

/// Mean, end by end. Exact for independent inputs; where rows share one, the
/// true range is no wider.
Interval mean_of(const std::vector<Interval>& intervals);

/// Largest element, end by end. Exact for independent inputs.
Interval largest_of(const std::vector<Interval>& intervals);

}  // namespace rebound
