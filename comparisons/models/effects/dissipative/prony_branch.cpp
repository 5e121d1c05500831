#include "comparisons/models/effects/dissipative/prony_branch.hpp"

#include <algorithm>

#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

bool all_relax(const Material& material, Relaxes what) {
  return std::all_of(material.branches.begin(), material.branches.end(),
                     [what](const PronyBranch& branch) { return branch.relaxes == what; });
}

void rescale_shares(Material& material, const PronyBranch& branch) {
  const double before = material.youngs_modulus;
  const double added = branch.ratio * before * (1.0 - fem::relaxing_shares(material).deviatoric);
  material.youngs_modulus = before + added;
  for (PronyBranch& other : material.branches) other.ratio *= before / material.youngs_modulus;
  material.branches.push_back(branch);
  material.branches.back().ratio = added / material.youngs_modulus;
}

/// Branches relax the deviator.
void deviator_as_long_term(Material& material) {
  const double long_term_share = 1.0 - fem::relaxing_shares(material).deviatoric;
  const fem::Moduli relaxed =
      fem::Moduli::from_youngs(long_term_share * material.youngs_modulus, material.poisson_ratio);
  const fem::Moduli moduli{relaxed.shear, fem::given_moduli(material).bulk};
  material.youngs_modulus = fem::youngs_modulus(moduli);
  material.poisson_ratio = fem::poisson_ratio(moduli);
  material.modulus = ModulusBasis::long_term;
  for (PronyBranch& branch : material.branches) branch.ratio /= long_term_share;
}

}  // namespace

void describe_as_long_term(Material& material) {
  if (material.modulus == ModulusBasis::long_term) return;
  if (all_relax(material, Relaxes::all)) {
    const double left = 1.0 - fem::relaxing_shares(material).deviatoric;
    material.youngs_modulus *= left;
    for (PronyBranch& branch : material.branches) branch.ratio /= left;
    material.modulus = ModulusBasis::long_term;
    return;
  }
  if (!all_relax(material, Relaxes::deviator))
    throw Error(ExitCode::bad_input,
                "branches of the instantaneous modulus relax partly all of the stress and partly "
                "the deviator, so that its shares cannot take a further branch; describe the "
                "material by its long-term modulus");
  deviator_as_long_term(material);
}

void add_prony_branch(Material& material, const PronyBranch& branch) {
  if (material.modulus == ModulusBasis::instantaneous && all_relax(material, Relaxes::all))
    return rescale_shares(material, branch);
  describe_as_long_term(material);
  material.branches.push_back(branch);
}

}  // namespace rebound
