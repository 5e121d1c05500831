// A branch added to a material leaves its long-term state and its other
// branches as they were, whatever the state it is described in.
#include "comparisons/models/effects/dissipative/prony_branch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/models/effects/dissipative/flat_spectrum.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

struct Moduli {
  double shear = 0.0, bulk = 0.0;
};

Moduli given_moduli(const Material& m) {
  return {.shear = 0.5 * m.youngs_modulus / (1.0 + m.poisson_ratio),
          .bulk = m.youngs_modulus / (3.0 * (1.0 - 2.0 * m.poisson_ratio))};
}

/// Shear and bulk modulus of one branch.
Moduli branch_moduli(const Material& m, std::size_t i) {
  const Moduli given = given_moduli(m);
  const PronyBranch& branch = m.branches[i];
  return {branch.ratio * given.shear,
          branch.relaxes == Relaxes::all ? branch.ratio * given.bulk : 0.0};
}

Moduli long_term_moduli(const Material& m) {
  Moduli moduli = given_moduli(m);
  if (m.modulus == ModulusBasis::long_term) return moduli;
  for (std::size_t i = 0; i < m.branches.size(); ++i) {
    moduli.shear -= branch_moduli(m, i).shear;
    moduli.bulk -= branch_moduli(m, i).bulk;
  }
  return moduli;
}

Material material(ModulusBasis basis, Relaxes relaxes) {
  return {.youngs_modulus = 9e6,
          .poisson_ratio = 0.38,
          .modulus = basis,
          .branches = {{.ratio = 0.3, .relaxation_time = 3e-4, .relaxes = relaxes},
                       {.ratio = 0.2, .relaxation_time = 2e-3, .relaxes = relaxes}}};
}

TEST(PronyBranchTest, LongTermModuliStay) {
  for (const auto basis : {ModulusBasis::instantaneous, ModulusBasis::long_term})
    for (const auto relaxes : {Relaxes::all, Relaxes::deviator}) {
      const Material before = material(basis, relaxes);
      Material after = before;
      add_prony_branch(after, {.ratio = 0.25, .relaxation_time = 1e-3, .relaxes = Relaxes::all});
      const Moduli old = long_term_moduli(before), now = long_term_moduli(after);
      EXPECT_NEAR(now.shear / old.shear, 1.0, 1e-13);
      EXPECT_NEAR(now.bulk / old.bulk, 1.0, 1e-13);
      ASSERT_EQ(after.branches.size(), 3u);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(branch_moduli(after, i).shear / branch_moduli(before, i).shear, 1.0, 1e-13);
        EXPECT_NEAR(branch_moduli(after, i).bulk, branch_moduli(before, i).bulk, 1e-6);
        EXPECT_EQ(after.branches[i].relaxation_time, before.branches[i].relaxation_time);
      }
      EXPECT_NEAR(branch_moduli(after, 2).shear / (0.25 * old.shear), 1.0, 1e-13);
      EXPECT_NEAR(branch_moduli(after, 2).bulk / (0.25 * old.bulk), 1.0, 1e-13);
    }
}

TEST(PronyBranchTest, SharesOfOneModulusCannotSayAMixture) {
  Material mixture = material(ModulusBasis::instantaneous, Relaxes::all);
  mixture.branches[1].relaxes = Relaxes::deviator;
  EXPECT_THROW(add_prony_branch(mixture, {.ratio = 0.25, .relaxation_time = 1e-3}), Error);
}

double modulus_at(const Material& material, double time) {
  double modulus = 1.0;
  for (const PronyBranch& branch : material.branches)
    modulus += branch.ratio * std::exp(-time / branch.relaxation_time);
  return modulus * material.youngs_modulus;
}

/// E(t) = E∞ (t/t_r)^(−s) from 1e-4 to 1 s, E∞ at t_r exactly. One branch a decade
/// leaves a ripple of amplitude 2 |Γ(s + iω)|/Γ(s), ω = 2π/ln 10: 0.06 s at most
/// here, twice that between t_r and its opposite phase.
TEST(FlatSpectrumTest, ModulusIsAPowerOfTime) {
  for (const double s : {0.02, 0.1, 0.3}) {
    Material material{.youngs_modulus = 5e6, .poisson_ratio = 0.3};
    relax_by_power_law(material, {.exponent = s, .reference_time = 1e-3});
    EXPECT_NEAR(modulus_at(material, 1e-3) / 5e6, 1.0, 1e-12);
    for (double time = 1e-4; time <= 1.0; time *= 1.7)
      EXPECT_NEAR(modulus_at(material, time) / (5e6 * std::pow(time / 1e-3, -s)), 1.0, 0.13 * s)
          << time;
  }
}

TEST(FlatSpectrumTest, NoExponentIsNoChange) {
  Material material{.youngs_modulus = 5e6,
                    .poisson_ratio = 0.3,
                    .branches = {{.ratio = 0.25, .relaxation_time = 1e-3}}};
  relax_by_power_law(material, {.exponent = 1e-9, .reference_time = 1e-3});
  EXPECT_EQ(material.modulus, ModulusBasis::long_term);
  EXPECT_NEAR(material.youngs_modulus / (0.75 * 5e6), 1.0, 1e-7);
  EXPECT_NEAR(material.branches[0].ratio, 1.0 / 3.0, 1e-7);
  for (std::size_t i = 1; i < material.branches.size(); ++i)
    EXPECT_LT(material.branches[i].ratio, 1e-8);
}

TEST(FlatSpectrumTest, RefusesWhatIsNoSpectrum) {
  for (const double s : {-0.1, 0.0, 1.0, std::nan("")}) {
    Material material{.youngs_modulus = 5e6, .poisson_ratio = 0.3};
    EXPECT_THROW(relax_by_power_law(material, {.exponent = s, .reference_time = 1e-3}), Error);
  }
}

}  // namespace
}  // namespace rebound
