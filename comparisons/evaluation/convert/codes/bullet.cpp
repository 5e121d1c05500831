#include <fmt/format.h>

#include <algorithm>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

/// btCollisionObject's own damping, which every other body adds.
constexpr double bullet_wall_damping = 0.1;

double bullet_damping(const CodeContact& contact) {
  return std::max(0.0, contact.at("damping") - bullet_wall_damping);
}

std::vector<ConvertedParameter> bullet_settings(const CodeContact& contact) {
  return {{"contactStiffness", contact.at("stiffness"), "N/m"},
          {"contactDamping", bullet_damping(contact), "N.s/m"},
          {"fixedTimeStep", contact.step, "s"}};
}

std::string bullet_lines(const CodeContact& contact) {
  const double k = contact.at("stiffness"), d = bullet_damping(contact);
  return fmt::format(
      "# PyBullet\n"
      "p.setTimeStep({:.9g})\n"
      "p.changeDynamics(ball, -1, mass={:.9g}, restitution=0, contactStiffness={:.9g}, "
      "contactDamping={:.9g})\n"
      "// C++\n"
      "ball->setRestitution(0);\n"
      "ball->setContactStiffnessAndDamping({:.9g}, {:.9g});\n"
      "world->stepSimulation({:.9g}, 1, {:.9g});\n",
      contact.step, contact.sphere.mass, k, d, k, d, contact.step, contact.step);
}

}  // namespace

// btManifoldResult.cpp: stiffnesses in series, dampings added (the wall keeps 1e18 N/m and
// 0.1 N s/m, btCollisionObject.cpp); btSequentialImpulseConstraintSolver.cpp,
// setupContactConstraint(): cfm = 1/(h k + c), erp = h k/(h k + c), the implicit spring and
// dashpot. A contact is made before the touch; there the distance d is taken off the speed as d/h.
OtherCode bullet_code() {
  return {.name = "bullet",
          .title = "Bullet, contact stiffness and damping",
          .convention = "linear-restitution",
          .separation = SeparationRule::zero_force,
          .force = "f = k d + c d', never below 0, at the end of each step",
          .source =
              "Bullet, btManifoldResult.cpp, btCollisionObject.cpp and "
              "btSequentialImpulseConstraintSolver.cpp",
          .cautions = {"set on the ball alone; the wall keeps the defaults, whose damping of "
                       "0.1 N.s/m is taken off",
                       "deflections have to stay below 40 mm, or SolverInfo's m_splitImpulse off: "
                       "deeper, the spring moves the ball and leaves its speed alone",
                       "errors below are those of its steps, too"},
          .stepping = ContactStepping::predicted,
          .settings = bullet_settings,
          .lines = bullet_lines};
}

}  // namespace rebound
