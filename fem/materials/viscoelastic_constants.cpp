#include "fem/materials/viscoelastic_constants.hpp"

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

void require(bool fine, const char* key, double value, const char* allowed) {
  if (fine) return;
  throw Error(ExitCode::bad_input,
              std::string("material: ") + key + " = " + std::to_string(value) +
                  " is out of range; allowed: " + allowed,
              {.key = std::string("model.material.") + key,
               .value = std::to_string(value),
               .allowed = allowed});
}

bool positive(double value) { return value > 0 && std::isfinite(value); }

void check(const Material& material) {
  require(positive(material.youngs_modulus), "youngs_modulus", material.youngs_modulus, "> 0 Pa");
  require(material.poisson_ratio > -1 && material.poisson_ratio <= largest_poisson_ratio,
          "poisson_ratio", material.poisson_ratio,
          "(-1, 0.45]; fully integrated cells lock above");
  double sum = 0.0;
  for (const auto& branch : material.branches) {
    require(positive(branch.ratio), "branch.ratio", branch.ratio, "> 0");
    require(positive(branch.relaxation_time), "branch.relaxation_time", branch.relaxation_time, "> 0 s");
    sum += branch.ratio;
  }
  if (material.modulus == ModulusBasis::instantaneous)
    require(sum < 1, "branch.ratio", sum, "sum of shares of the instantaneous modulus below 1");
}

}  // namespace

ViscoelasticConstants viscoelastic_constants(const Material& material) {
  check(material);
  const Moduli given = Moduli::from_youngs(material.youngs_modulus, material.poisson_ratio);
  double ratio_deviatoric = 0.0;
  double ratio_volumetric = 0.0;
  for (const auto& branch : material.branches) {
    ratio_deviatoric += branch.ratio;
    if (branch.relaxes == Relaxes::all) ratio_volumetric += branch.ratio;
  }

  ViscoelasticConstants constants;
  const bool long_term = material.modulus == ModulusBasis::long_term;
  const double scale_deviatoric = long_term ? 1.0 + ratio_deviatoric : 1.0;
  const double scale_volumetric = long_term ? 1.0 + ratio_volumetric : 1.0;
  constants.instantaneous = {given.shear * scale_deviatoric, given.bulk * scale_volumetric};
  for (const auto& branch : material.branches) {
    const bool all = branch.relaxes == Relaxes::all;
    constants.branches.push_back({branch.ratio / scale_deviatoric,
                                  all ? branch.ratio / scale_volumetric : 0.0,
                                  branch.relaxation_time});
  }
  constants.long_term_deviatoric = 1.0 - ratio_deviatoric / scale_deviatoric;
  constants.long_term_volumetric = 1.0 - ratio_volumetric / scale_volumetric;
  return constants;
}

}  // namespace rebound::fem
