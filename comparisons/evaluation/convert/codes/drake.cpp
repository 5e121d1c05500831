#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

double drake_dissipation(const CodeContact& contact) {
  return contact.at("damping") / contact.at("stiffness");
}

std::vector<ConvertedParameter> drake_settings(const CodeContact& contact) {
  return {{"point_contact_stiffness", 2.0 * contact.at("stiffness"), "N/m"},
          {"hunt_crossley_dissipation", drake_dissipation(contact), "s/m"}};
}

std::string drake_lines(const CodeContact& contact) {
  return fmt::format(
      "<!-- in the collision of the ball and in that of the wall -->\n"
      "<drake:proximity_properties>\n"
      "  <drake:point_contact_stiffness>{:.9g}</drake:point_contact_stiffness>\n"
      "  <drake:hunt_crossley_dissipation>{:.9g}</drake:hunt_crossley_dissipation>\n"
      "  <drake:mu_dynamic>0.0</drake:mu_dynamic>\n"
      "  <drake:mu_static>0.0</drake:mu_static>\n"
      "</drake:proximity_properties>\n"
      "<!-- in C++: plant.set_contact_model(drake::multibody::ContactModel::kPoint) -->\n",
      2.0 * contact.at("stiffness"), drake_dissipation(contact));
}

}  // namespace

// Tags and units: Drake's list of its SDFormat and URDF tags (multibody/parsing/
// parsing_doxygen.h); the model: "Compliant Point Contact" of its documentation of contacts,
// f = k x (1 + d x')₊; how two bodies combine: multibody/plant/contact_properties.h, k =
// k₁ k₂/(k₁ + k₂), d = k₂/(k₁ + k₂) d₁ + k₁/(k₁ + k₂) d₂, so that two alike keep d and halve k.
// Both say it, for a body that says nothing has the defaults of SceneGraphConfig.
OtherCode drake_code() {
  return {.name = "drake",
          .title = "Drake, compliant point contact with Hunt-Crossley dissipation",
          .convention = "hunt-crossley-linear",
          .separation = SeparationRule::zero_force,
          .force = "f = k d (1 + D d'), never below 0",
          .source =
              "Drake documentation, Compliant Point Contact; "
              "multibody/parsing/parsing_doxygen.h; multibody/plant/contact_properties.h",
          .cautions = {"both bodies have the stiffness below, which is twice that of the contact",
                       "errors below are those of a continuous plant (time_step 0)",
                       "a discrete plant honours the dissipation with the contact approximations "
                       "tamsi, similar and lagged, not with sap, which takes a relaxation time"},
          .stepping = {},
          .settings = drake_settings,
          .lines = drake_lines};
}

}  // namespace rebound
