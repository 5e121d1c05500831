#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_run.hpp"
#include "comparisons/discrepancy/trials/trial_share.hpp"

namespace rebound {

/// χ² of the noise-free records against the refitted believed model, below which data do not hold
/// an effect.
inline constexpr double smallest_visible_chi_square = 25.0;

/// Chance that noise leaves the hidden form itself ahead of the form of another family that is most
/// like it, by as much as one candidate must be better than another:
///
///   P( d² + 2 d z > 6 ),   d² = χ² (1 − c²),   z normal
///
///   χ²  visible χ² of the effect         c  cosine of what both leave over
///
/// No choice among unknown forms can do better than this one between two known ones.
/// Limit:   a rival that is the same leaves nothing -> test TrialScoreTest.AtBestARivalDecides.
double chance_of_family_at_best(double visible_chi_square, double cosine);

/// How often an effect is found and named, in one bin of something.
struct RateRow {
  std::string label;
  double low = 0.0, high = 0.0;  ///< edges of the bin; equal for a single value, zero for a word
  int trials = 0;                ///< effects in the bin
  Share detected;                ///< a gap is said
  Share family_right;
  /// Chance that the family could be told at best, on average; nothing where no rival is known.
  std::optional<double> family_at_best;
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
