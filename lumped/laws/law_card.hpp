#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/dimension.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// What a user must know of one parameter of a contact law. The configuration
/// reader, `--help`, calibration and the JSON schema all read this one
/// declaration.
struct ParameterCard {
  std::string name;  ///< TOML key, e.g. "stiffness"
  std::string sentence;
  /// Dimension of the value. A stiffness in N/mⁿ depends on the exponent that
  /// stands beside it, hence a function of all values read so far.
  Dimension (*dimension)(const ParameterValues&);
  double lowest = 0.0;                  ///< smallest allowed value, SI
  double highest = 0.0;                 ///< largest allowed value, SI
  bool lowest_allowed = true;           ///< is the lower limit itself allowed
  std::optional<double> default_value;  ///< absent: the user must give it
};

/// What a user must know of one contact law.
struct LawCard {
  std::string name;      ///< TOML value of `law`, e.g. "hunt-crossley"
  std::string equation;  ///< one line, as printed by --help
  std::string source;
  std::vector<ParameterCard> parameters;  ///< those that set dimensions first
  /// The parameter that a restitution and a damping formula can stand in for;
  /// empty when the law has none.
  std::string damping_parameter;
};

}  // namespace rebound
