#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/dimension.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/validity.hpp"

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
  Range range;                          ///< SI
  std::optional<double> default_value;  ///< absent: the user must give it
  /// A value with which a ball of 90 g and 66 mm at 15 m/s returns 0.4 to 0.8 of its speed, SI.
  double typical = 0.0;
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
  /// The parameter that takes energy away; at zero the law is elastic.
  std::string loss_parameter;
};

/// Cards of all laws, in the order of laws.inc.
const std::vector<LawCard>& all_laws();

/// Errors: Error(bad_input) with the names there are.
const LawCard& find_law(const std::string& name);

/// Does the law carry a state of its own, a relaxing branch? Then it is integrated as a
/// composed contact, and its `force` is the part without the state.
bool has_branch(const std::string& law);

}  // namespace rebound
