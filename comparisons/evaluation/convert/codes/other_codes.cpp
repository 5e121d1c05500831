#include "comparisons/evaluation/convert/codes/other_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lumped/laws/exact_restitution.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

#define REBOUND_CODE(name) OtherCode name##_code();
#include "comparisons/evaluation/convert/codes/codes.inc"
#undef REBOUND_CODE

const std::vector<OtherCode>& other_codes() {
  static const std::vector<OtherCode> codes = {
#define REBOUND_CODE(name) name##_code(),
#include "comparisons/evaluation/convert/codes/codes.inc"
#undef REBOUND_CODE
  };
  return codes;
}

const OtherCode& other_code(const std::string& name) {
  std::string names;
  for (const OtherCode& code : other_codes()) {
    if (name == code.name) return code;
    names += (names.empty() ? "" : ", ") + std::string(code.name);
  }
  throw Error(ExitCode::bad_input, "no lines are known for this code",
              {.key = "--to", .value = name, .allowed = names});
}

double CodeContact::hertz_modulus(std::optional<double> radius) const {
  return 0.75 * at("stiffness") / std::sqrt(radius.value_or(sphere.radius()));
}

double CodeContact::asked_restitution() const {
  const double zeta = at("damping") / std::sqrt(5.0 * sphere.mass * at("stiffness"));
  if (!(zeta < 1.0))
    throw Error(ExitCode::solver_failed,
                "so much loss is asked for by no restitution of this code: its damping would be "
                "overcritical");
  return kelvin_voigt_restitution(zeta, SeparationRule::zero_deflection);
}

}  // namespace rebound
