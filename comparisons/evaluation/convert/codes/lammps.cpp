#include <fmt/format.h>

#include <cmath>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

double lammps_stiffness(const CodeContact& contact) {
  return contact.at("stiffness") / std::sqrt(contact.sphere.radius());
}

std::vector<ConvertedParameter> lammps_settings(const CodeContact& contact) {
  return {{"kn", lammps_stiffness(contact), "Pa"}, {"en", contact.asked_restitution(), "1"}};
}

std::string lammps_lines(const CodeContact& contact) {
  const std::string model = fmt::format(
      "hertz {:.9g} {:.9g} tangential linear_nohistory 0.0 0.0 damping coeff_restitution",
      lammps_stiffness(contact), contact.asked_restitution());
  return fmt::format(
      "units si\n"
      "pair_style granular\n"
      "pair_coeff * * {}\n"
      "fix wall all wall/gran granular {} zplane 0.0 NULL\n"
      "set group all diameter {:.9g} density {:.9g}\n",
      model, model, contact.sphere.diameter, contact.sphere.density());
}

}  // namespace

// The formula of src/GRANULAR/gran_sub_mod_damping.cpp (coeff_restitution: √5 |ln e|/√(π² + ln² e),
// times √(m kn √R) δ^¼) and the documentation of `pair_style granular`; the wall's effective radius
// and mass are those of the ball. The wall lines follow unittest/granular/tests/dem03-hertz-*.yaml.
OtherCode lammps_code() {
  return {.name = "lammps",
          .title = "LAMMPS, pair_style granular, hertz with damping coeff_restitution",
          .convention = "hertz-restitution",
          .separation = SeparationRule::zero_deflection,
          .force = "F = kn sqrt(R) d^1.5 + eta d' with eta of the restitution en",
          .source =
              "LAMMPS documentation, pair_style granular and fix wall/gran; "
              "src/GRANULAR/gran_sub_mod_damping.cpp",
          .cautions = {"the force pulls at the end of the contact unless limit_damping is given"},
          .stepping = {},
          .settings = lammps_settings,
          .lines = lammps_lines};
}

}  // namespace rebound
