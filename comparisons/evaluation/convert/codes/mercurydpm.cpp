#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/other_code.hpp"

namespace rebound {
namespace {

std::vector<ConvertedParameter> mercurydpm_settings(const CodeContact& contact) {
  return {{"effective_elastic_modulus", contact.hertz_modulus(), "Pa"},
          {"restitution", contact.asked_restitution(), "1"}};
}

std::string mercurydpm_lines(const CodeContact& contact) {
  return fmt::format(
      "HertzianViscoelasticMindlinSpecies species;\n"
      "species.setDensity({:.9g});\n"
      "species.setEffectiveElasticModulusAndRestitutionCoefficient({:.9g}, {:.9g});\n"
      "species.setSlidingFrictionCoefficient(0.0);\n"
      "speciesHandler.copyAndAddObject(species);\n"
      "SphericalParticle ball;\n"
      "ball.setSpecies(speciesHandler.getObject(0));\n"
      "ball.setRadius({:.9g});\n"
      "ball.setVelocity(Vec3D(0.0, 0.0, -{:.9g}));\n"
      "InfiniteWall wall;\n"
      "wall.setSpecies(speciesHandler.getObject(0));\n"
      "wall.set(Vec3D(0.0, 0.0, -1.0), Vec3D(0.0, 0.0, 0.0));\n",
      contact.sphere.density(), contact.hertz_modulus(), contact.asked_restitution(),
      contact.sphere.radius(), contact.speed);
}

}  // namespace

// Kernel/Interactions/NormalForceInteractions/HertzianViscoelasticInteraction.cc:
// kn = (4/3) E* √(R* δ), force kn δ + γ √(m* kn) δ'; HertzianViscoelasticNormalSpecies.cc:
// γ = √(5 ln² e/(ln² e + π²)). Older versions call the setter setElasticModulusAndRestitution...
OtherCode mercurydpm_code() {
  return {.name = "mercurydpm",
          .title = "MercuryDPM, HertzianViscoelasticMindlinSpecies",
          .convention = "hertz-restitution",
          .separation = SeparationRule::zero_deflection,
          .force = "F = kn d + gamma sqrt(m* kn) d', kn = 4/3 E* sqrt(R* d)",
          .source =
              "MercuryDPM, Kernel/Species/NormalForceSpecies/"
              "HertzianViscoelasticNormalSpecies.cc",
          .cautions = {"the force pulls at the end of the contact"},
          .stepping = {},
          .settings = mercurydpm_settings,
          .lines = mercurydpm_lines};
}

}  // namespace rebound
