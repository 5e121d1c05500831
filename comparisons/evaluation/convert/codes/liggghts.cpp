#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/same_material.hpp"

namespace rebound {
namespace {

std::vector<ConvertedParameter> liggghts_settings(const CodeContact& contact) {
  return {{"youngsModulus", modulus_of_both(contact.hertz_modulus()), "Pa"},
          {"poissonsRatio", material_poisson_ratio, "1"},
          {"coefficientRestitution", contact.asked_restitution(), "1"}};
}

std::string liggghts_lines(const CodeContact& contact) {
  return fmt::format(
      "units si\n"
      "fix m1 all property/global youngsModulus peratomtype {:.9g}\n"
      "fix m2 all property/global poissonsRatio peratomtype {:g}\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair 1 {:.9g}\n"
      "fix m4 all property/global coefficientFriction peratomtypepair 1 0.0\n"
      "pair_style gran model hertz tangential history\n"
      "pair_coeff * *\n"
      "fix wall all wall/gran model hertz tangential history primitive type 1 zplane 0.0\n"
      "set group all diameter {:.9g} density {:.9g}\n",
      modulus_of_both(contact.hertz_modulus()), material_poisson_ratio, contact.asked_restitution(),
      contact.sphere.diameter, contact.sphere.density());
}

}  // namespace

// gran model hertz of the LIGGGHTS-PUBLIC manual: kn = (4/3) Y* √(R* δ),
// γn = −2 √(5/6) β √(Sn m*), Sn = 2 Y* √(R* δ), β = ln e/√(ln² e + π²): Tsuji's damping.
OtherCode liggghts_code() {
  return {.name = "liggghts",
          .title = "LIGGGHTS, gran model hertz",
          .convention = "hertz-restitution",
          .separation = SeparationRule::zero_deflection,
          .force = "F = 4/3 Y* sqrt(R*) d^1.5 - 2 sqrt(5/6) beta sqrt(Sn m*) d'",
          .source = "LIGGGHTS(R)-PUBLIC documentation, gran model hertz",
          .cautions = {"ball and wall are of one atom type: Y* = E/(2 (1 - nu^2))",
                       "limitForce is off, as by default: the force pulls at the end"},
          .stepping = {},
          .settings = liggghts_settings,
          .lines = liggghts_lines};
}

}  // namespace rebound
