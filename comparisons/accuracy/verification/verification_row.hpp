#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rebound {

/// What a deviation is measured in.
enum class ToleranceScale {
  relative,    ///< |result / target − 1|
  absolute,    ///< |result − target|, in the row's unit
  upper_bound  ///< what result has above target, in the row's unit
};

/// One line of the verification suite: a number that is known, and what the
/// program makes of it.
struct VerificationRow {
  std::string case_id;
  std::string quantity;  ///< what, of which case
  std::string unit;      ///< empty for ratios
  double target = 0.0;
  double result = 0.0;
  double tolerance = 0.0;
  ToleranceScale scale = ToleranceScale::relative;
  std::optional<double> order{};  ///< observed under refinement, where a family was run
  std::string source;             ///< of the target

  double deviation() const;
  /// Never true for a result that is no number.
  bool passes() const { return deviation() <= tolerance; }
};

using VerificationTable = std::vector<VerificationRow>;

bool all_pass(const VerificationTable& table);

/// Puts `rows` behind those of `table`.
void append(VerificationTable& table, VerificationTable rows);

}  // namespace rebound
