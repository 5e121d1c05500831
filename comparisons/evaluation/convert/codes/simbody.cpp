#include <fmt/format.h>

#include <cmath>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

/// Both surfaces are given E, which Simbody raises to K = E^(2/3) itself; then k = K/2 in
/// f = (4/3) k^1.5 √R x^1.5 (1 + 1.5 c x'), so that k^1.5 = E/2^1.5 is to be E*.
double simbody_stiffness(const CodeContact& contact) {
  return std::pow(2.0, 1.5) * contact.hertz_modulus();
}

double simbody_dissipation(const CodeContact& contact) {
  return contact.at("damping") / (1.5 * contact.at("stiffness"));
}

std::vector<ConvertedParameter> simbody_settings(const CodeContact& contact) {
  return {{"stiffness", simbody_stiffness(contact), "Pa"},
          {"dissipation", simbody_dissipation(contact), "s/m"}};
}

std::string simbody_lines(const CodeContact& contact) {
  return fmt::format(
      "HuntCrossleyForce hc(forces, contacts, setIndex);\n"
      "// surface 0: the wall, surface 1: a ball of radius {:.9g}; no friction\n"
      "hc.setBodyParameters(ContactSurfaceIndex(0), {:.9g}, {:.9g}, 0.0, 0.0, 0.0);\n"
      "hc.setBodyParameters(ContactSurfaceIndex(1), {:.9g}, {:.9g}, 0.0, 0.0, 0.0);\n",
      contact.sphere.radius(), simbody_stiffness(contact), simbody_dissipation(contact),
      simbody_stiffness(contact), simbody_dissipation(contact));
}

}  // namespace

// Simbody/src/HuntCrossleyForce.cpp: k = k₁ k₂/(k₁ + k₂), c weighted, f = (4/3) k x √(R k x)
// (1 + 1.5 c x'), no less than zero; HuntCrossleyForceImpl.h, Parameters: what is set is raised to
// the power 2/3 before that.
OtherCode simbody_code() {
  return {.name = "simbody",
          .title = "Simbody, HuntCrossleyForce",
          .convention = "hunt-crossley/exact",
          .separation = SeparationRule::zero_force,
          .force = "f = 4/3 k d sqrt(R k d) (1 + 1.5 c d')",
          .source = "Simbody, Simbody/src/HuntCrossleyForce.cpp and HuntCrossleyForceImpl.h",
          .cautions =
              {"both surfaces have the stiffness below, a modulus: two of one give E*/2^1.5 of it"},
          .stepping = {},
          .settings = simbody_settings,
          .lines = simbody_lines};
}

}  // namespace rebound
