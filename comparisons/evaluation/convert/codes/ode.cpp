#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

struct OdeSoftness {
  double erp = 0.0;  ///< h k/(h k + c)
  double cfm = 0.0;  ///< 1/(h k + c) [m/(N s)]
};

OdeSoftness ode_softness(const CodeContact& contact) {
  const double hk = contact.step * contact.at("stiffness"), sum = hk + contact.at("damping");
  return {.erp = hk / sum, .cfm = 1.0 / sum};
}

std::vector<ConvertedParameter> ode_settings(const CodeContact& contact) {
  const OdeSoftness soft = ode_softness(contact);
  return {
      {"soft_erp", soft.erp, "1"}, {"soft_cfm", soft.cfm, "m/(N.s)"}, {"step", contact.step, "s"}};
}

std::string ode_lines(const CodeContact& contact) {
  const OdeSoftness soft = ode_softness(contact);
  return fmt::format(
      "contact.surface.mode = dContactSoftERP | dContactSoftCFM;\n"
      "contact.surface.mu = 0;\n"
      "contact.surface.soft_erp = {:.9g};\n"
      "contact.surface.soft_cfm = {:.9g};\n"
      "dMassSetSphereTotal(&mass, {:.9g}, {:.9g});\n"
      "dWorldStep(world, {:.9g});\n",
      soft.erp, soft.cfm, contact.sphere.mass, contact.sphere.radius(), contact.step);
}

}  // namespace

// ODE manual, "How to use ERP and CFM": ERP = h k/(h k + c), CFM = 1/(h k + c) give the implicitly
// integrated spring and dashpot; "Contact" for the surface's members.
OtherCode ode_code() {
  return {.name = "ode",
          .title = "Open Dynamics Engine, soft contact",
          .convention = "linear-restitution",
          .separation = SeparationRule::zero_force,
          .force = "f = k d + c d', never below 0, at the end of each step",
          .source = "ODE manual, How to use ERP and CFM",
          .cautions = {"ERP and CFM hold for this step alone",
                       "errors below are those of its steps, too"},
          .stepping = ContactStepping::implicit,
          .settings = ode_settings,
          .lines = ode_lines};
}

}  // namespace rebound
