#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/same_material.hpp"

namespace rebound {
namespace {

std::vector<ConvertedParameter> chrono_settings(const CodeContact& contact) {
  return {{"young_modulus", modulus_of_both(contact.hertz_modulus()), "Pa"},
          {"poisson_ratio", material_poisson_ratio, "1"},
          {"restitution", contact.asked_restitution(), "1"},
          {"effective_radius", contact.sphere.radius(), "m"}};
}

std::string chrono_lines(const CodeContact& contact) {
  return fmt::format(
      "ChSystemSMC sys;\n"
      "sys.SetCollisionSystemType(ChCollisionSystem::Type::BULLET);\n"
      "sys.SetContactForceModel(ChSystemSMC::ContactForceModel::Hertz);\n"
      "ChCollisionInfo::SetDefaultEffectiveCurvatureRadius({:.9g});\n"
      "auto mat = chrono_types::make_shared<ChContactMaterialSMC>();\n"
      "mat->SetYoungModulus({:.9g}f);\n"
      "mat->SetPoissonRatio({:g}f);\n"
      "mat->SetRestitution({:.9g}f);\n"
      "mat->SetFriction(0.0f);\n"
      "mat->SetAdhesion(0.0f);\n"
      "auto ball = chrono_types::make_shared<ChBodyEasySphere>({:.9g}, {:.9g}, true, true, mat);\n"
      "ball->SetPosDt(ChVector3d(0, -{:.9g}, 0));\n"
      "sys.AddBody(ball);\n",
      contact.sphere.radius(), modulus_of_both(contact.hertz_modulus()), material_poisson_ratio,
      contact.asked_restitution(), contact.sphere.radius(), contact.sphere.density(),
      contact.speed);
}

}  // namespace

// src/chrono/physics/ChContactSMC.h, model Hertz with material properties: Sn = 2 E* √(R δ),
// kn = (2/3) Sn, gn = −2 √(5/6) β √(Sn m); a negative force is set to zero.
OtherCode chrono_code() {
  return {.name = "chrono",
          .title = "Project Chrono, ChSystemSMC, contact force model Hertz",
          .convention = "hertz-restitution",
          .separation = SeparationRule::zero_force,
          .force =
              "F = 4/3 E* sqrt(R) d^1.5 + 2 sqrt(5/6) |beta| sqrt(2 E* sqrt(R) m) d^0.25 d', "
              "never below 0",
          .source = "Project Chrono, src/chrono/physics/ChContactSMC.h",
          .cautions = {"the wall's body is fixed and has the same material; its mass enters the "
                       "effective one, so it has to be large",
                       "it cuts the tension: the restitution below is what has to be asked for",
                       "moduli are single precision"},
          .stepping = {},
          .settings = chrono_settings,
          .lines = chrono_lines};
}

}  // namespace rebound
