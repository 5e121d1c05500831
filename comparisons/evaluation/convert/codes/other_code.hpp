#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/evaluation/convert/codes/stepped_contact.hpp"
#include "comparisons/evaluation/convert/conversion.hpp"

namespace rebound {

/// A contact as another code is to hold it, in numbers that its lines are made from.
struct CodeContact {
  Sphere sphere;
  double speed = 0.0;      ///< at which the numbers hold [m/s]
  ParameterValues values;  ///< of the code's law
  double step = 0.0;       ///< of a code that steps through contacts, else 0 [s]

  double at(const char* parameter) const { return values.at(parameter); }
  /// E* of F = (4/3) E* √R x^1.5; `radius` where the code takes another one than the ball's [Pa].
  double hertz_modulus(std::optional<double> radius = {}) const;
  /// The restitution one asks a code for whose Hertz damping keeps its tension in its formula.
  ///
  ///   e = exp(−π ζ/√(1 − ζ²)),   ζ = λ/√(5 m κ)
  ///
  /// Errors: Error(solver_failed) for ζ ≥ 1, which no restitution asks for.
  double asked_restitution() const;
};

/// One other code, and how one tells it a normal contact of a ball with a wall at rest.
struct OtherCode {
  const char* name;           ///< of --to
  const char* title;          ///< the code, and which of its models
  const char* convention;     ///< of target_conventions(): law, loss and first guess
  SeparationRule separation;  ///< zero_force: its force never pulls
  const char* force;          ///< what it integrates, in its own symbols
  const char* source;         ///< where its documentation or source says so
  std::vector<const char*> cautions;
  std::optional<ContactStepping> stepping;  ///< a code whose steps are too long to be left out
  std::vector<ConvertedParameter> (*settings)(const CodeContact& contact);
  std::string (*lines)(const CodeContact& contact);  ///< what is pasted
};

const std::vector<OtherCode>& other_codes();
/// Errors: Error(bad_input), key --to, with the names that there are.
const OtherCode& other_code(const std::string& name);

}  // namespace rebound
