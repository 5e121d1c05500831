#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

double mujoco_of_mass(const CodeContact& contact, const char* parameter) {
  return contact.at(parameter) / contact.sphere.mass;
}

std::vector<ConvertedParameter> mujoco_settings(const CodeContact& contact) {
  return {{"stiffness", mujoco_of_mass(contact, "stiffness"), "1/s^2"},
          {"damping", mujoco_of_mass(contact, "damping"), "1/s"},
          {"timestep", contact.step, "s"}};
}

std::string mujoco_lines(const CodeContact& contact) {
  return fmt::format(
      "<option timestep=\"{:.9g}\" integrator=\"Euler\"/>\n"
      "<geom type=\"sphere\" size=\"{:.9g}\" mass=\"{:.9g}\" condim=\"1\" priority=\"1\"\n"
      "      solref=\"-{:.9g} -{:.9g}\" solimp=\"0.95 0.95 0.001 0.5 2\"/>\n",
      contact.step, contact.sphere.radius(), contact.sphere.mass,
      mujoco_of_mass(contact, "stiffness"), mujoco_of_mass(contact, "damping"));
}

}  // namespace

// Chapter "Modeling", solver parameters: a₁ + d (b v + k r) = (1 − d) a₀, and in the direct form
// b = damping/dmax, k = stiffness d(r)/dmax². A constant impedance d leaves x'' = −damping x' −
// stiffness x where nothing else acts, whatever d. The force of a contact is no less than zero.
OtherCode mujoco_code() {
  return {.name = "mujoco",
          .title = "MuJoCo, soft contact with solref in its direct form",
          .convention = "linear-restitution",
          .separation = SeparationRule::zero_force,
          .force = "x'' = -stiffness x - damping x', never pulling",
          .source = "MuJoCo documentation, Modeling: Solver parameters",
          .cautions = {"both numbers are per mass of the ball: another mass, other numbers",
                       "impedance is constant (solimp), gravity alone acts with the share 1 - d of "
                       "itself",
                       "errors below are those of its steps, too"},
          .stepping = ContactStepping::semi_implicit,
          .settings = mujoco_settings,
          .lines = mujoco_lines};
}

}  // namespace rebound
