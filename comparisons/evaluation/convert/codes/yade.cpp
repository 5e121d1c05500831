#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/same_material.hpp"

namespace rebound {
namespace {

double yade_modulus(const CodeContact& contact) {
  return modulus_of_both(contact.hertz_modulus(0.5 * contact.sphere.radius()));
}

std::vector<ConvertedParameter> yade_settings(const CodeContact& contact) {
  return {{"young", yade_modulus(contact), "Pa"},
          {"poisson", material_poisson_ratio, "1"},
          {"en", contact.asked_restitution(), "1"}};
}

std::string yade_lines(const CodeContact& contact) {
  const double e = contact.asked_restitution();
  return fmt::format(
      "ball = O.materials.append(FrictMat(young={:.9g}, poisson={:g}, density={:.9g}, "
      "frictionAngle=0))\n"
      "O.bodies.append(utils.wall(position=0, axis=2, material=ball))\n"
      "O.bodies.append(sphere(center=(0, 0, {:.9g}), radius={:.9g}, material=ball))\n"
      "O.engines = [ForceResetter(),\n"
      "             InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),\n"
      "             InteractionLoop([Ig2_Wall_Sphere_ScGeom()],\n"
      "                             [Ip2_FrictMat_FrictMat_MindlinPhys(en={:.9g}, es={:.9g})],\n"
      "                             [Law2_ScGeom_MindlinPhys_Mindlin()]),\n"
      "             NewtonIntegrator(damping=0, gravity=(0, 0, 0))]\n"
      "O.bodies[1].state.vel = (0, 0, -{:.9g})\n",
      yade_modulus(contact), material_poisson_ratio, contact.sphere.density(),
      contact.sphere.diameter, contact.sphere.radius(), e, e, contact.speed);
}

}  // namespace

// pkg/dem/HertzMindlin.cpp: kno = (4/3) E √R with R = R₁ R₂/(R₁ + R₂) and
// α = −√(5/6) 2 ln e/√(ln² e + π²) √(2 E √R), times √m δ^¼ with the mass of the one body that
// moves; a viscous force above the elastic one is cut (old versions let the force pull).
// pkg/dem/Ig2_Facet_Sphere_ScGeom.cpp gives a wall (utils.wall) the radius of the sphere: R is half
// of it. A facet has had twice the sphere's radius in old versions: 2/3 of it.
OtherCode yade_code() {
  return {.name = "yade",
          .title = "Yade, Law2_ScGeom_MindlinPhys_Mindlin",
          .convention = "hertz-restitution",
          .separation = SeparationRule::zero_force,
          .force = "F = 4/3 E* sqrt(R/2) d^1.5 + alpha sqrt(m) d^0.25 d', never below 0",
          .source = "Yade, pkg/dem/HertzMindlin.cpp and Ig2_Facet_Sphere_ScGeom.cpp",
          .cautions = {"Yade takes a wall for a sphere of the same radius, so its effective radius "
                       "is R/2; young makes up for that and holds for this ball on a wall alone",
                       "it cuts the tension: en is what has to be asked for"},
          .stepping = {},
          .settings = yade_settings,
          .lines = yade_lines};
}

}  // namespace rebound
