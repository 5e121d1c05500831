#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/evaluation/convert/codes/other_code.hpp"
#include "comparisons/evaluation/convert/conversion.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// What one wants of a code's lines beside the contact itself.
struct CodeRequest {
  std::vector<double> speeds;     ///< where errors are taken; empty: a third to five thirds [m/s]
  std::optional<double> step;     ///< of a code that steps; absent: a 500th of the contact [s]
  std::optional<FemProblem> fem;  ///< of the same ball: errors against FE, too
  FemRunner run;                  ///< of `fem`
};

/// What the lines do at one speed, and by how much that misses.
struct CodeError {
  double speed = 0.0;   ///< [m/s]
  Observed returned;    ///< by the code's formula, separation and steps
  std::string failure;  ///< why it returns nothing
  /// Of a code that steps: lowest and highest restitution, as the touch falls into a step.
  std::optional<std::array<double, 2>> restitution_range;
  std::optional<Observed> of_law;  ///< error against what was given, where that is known there
  std::optional<Observed> of_fem;  ///< error against FE
  std::string fem_failure;
};

/// Lines for one code, and how far they carry.
struct CodeConversion {
  CodeContact contact;
  std::vector<ConvertedParameter> settings;
  std::string lines;
  std::vector<CodeError> errors;
};

/// The numbers with which a code's own contact returns what is given at the speed of the
/// conversion: restitution, and contact time where there is one, with the code's rule of
/// separation. Errors: e as a difference, time and force as a share.
///
/// Valid:   normal impact on a rigid wall at rest; gravity left out.
/// Limit:   at its own speed a code without steps has no error in restitution and contact time
///          -> test OtherCodesTest.HoldAtTheirOwnSpeed.
/// Caution: a contact time is that by the code's rule; one given by the other rule is another time.
/// Errors:  those of meaning_of() and matched_law(); Error(bad_input) for a speed, a step, or an FE
///          problem of another ball.
CodeConversion convert_to_code(const OtherCode& code, const ConversionRequest& request,
                               const CodeRequest& options);

}  // namespace rebound
