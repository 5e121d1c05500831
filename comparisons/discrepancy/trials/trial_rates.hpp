#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_run.hpp"
#include "comparisons/discrepancy/trials/trial_share.hpp"

namespace rebound {

/// χ² of the noise-free records against the refitted believed model, below which data do not hold
/// an effect.
inline constexpr double smallest_visible_chi_square = 25.0;

/// How often an effect is found and named, in one bin of something.
struct RateRow {
  std::string label;
  double low = 0.0, high = 0.0;  ///< edges of the bin; equal for a single value, zero for a word
  int trials = 0;                ///< effects in the bin
  Share detected;                ///< a gap is said
  Share family_right;
  Share name_right;  ///< or in the set
  Share wrong_name;
  Share false_alarm;  ///< of the nulls in the bin
};

struct RateTable {
  std::string by;    ///< key in JSON, e.g. "visible_chi_square"
  std::string what;  ///< in words
  std::string unit;
  std::vector<RateRow> rows;
};

/// Rates over the size of an effect, by its visible χ²; and for effects that show over level,
/// colour and statement of the noise, number of speeds and of shots.
///
/// Counted are single effects of a family. Bins without a trial are left out.
std::vector<RateTable> rates_of(const std::vector<TrialRecord>& records);

}  // namespace rebound
