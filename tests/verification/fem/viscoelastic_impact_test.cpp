// Impacts with Prony branches, and what must hold whatever their numbers:
// where the energy went, limits of the relaxation time, order of restitution.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/interface/elastic_models.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

const Mesh& viscoelastic_mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 500});
  return made;
}

FemProblem with_branch(double ratio, double relaxation_time, Relaxes relaxes) {
  FemProblem problem = test::common_case(15.0);
  if (ratio > 0.0) problem.material.branches = {{ratio, relaxation_time, relaxes}};
  return problem;
}

FemResult viscoelastic_impact(double ratio, double relaxation_time, Relaxes relaxes) {
  return test::checked_impact(viscoelastic_mesh(), with_branch(ratio, relaxation_time, relaxes));
}

TEST(ViscoelasticImpact, EnergyLostIsEnergyCounted) {
  for (const auto relaxes : {Relaxes::all, Relaxes::deviator})
    for (const double ratio : {0.1, 0.5}) {
      const FemResult result = viscoelastic_impact(ratio, 0.3e-3, relaxes);
      const double e = result.restitution_momentum;
      const double brought = 0.5 * 0.0896 * 15.0 * 15.0;
      const EnergyBalance& end = result.energies.back();
      const double branches = (end.held + end.dissipated) / brought;
      EXPECT_NEAR(1.0 - e * e,
                  branches + result.vibrational_energy_share + result.contact_constraint_share,
                  3e-4);
      EXPECT_GT(branches, 0.5 * ratio);
      ASSERT_EQ(result.energies.size(), result.trace.time.size());
      // Energy that branches hold may come back; never more than they took.
      for (const auto& balance : result.energies) EXPECT_GT(balance.dissipated, -1e-4 * brought);
    }
}

TEST(ViscoelasticImpact, RestitutionFallsAsTheBranchGrows) {
  for (const auto relaxes : {Relaxes::all, Relaxes::deviator}) {
    double before = 1.0;
    for (const double ratio : {0.0, 0.1, 0.3, 0.5}) {
      const double e = viscoelastic_impact(ratio, 0.3e-3, relaxes).restitution_momentum;
      EXPECT_LT(e, before - 0.01) << ratio;
      before = e;
    }
    EXPECT_GT(before, 0.5);
  }
}

TEST(ViscoelasticImpact, BranchOfAllLosesMoreThanOfTheDeviator) {
  EXPECT_LT(viscoelastic_impact(0.4, 0.3e-3, Relaxes::all).restitution_momentum,
            viscoelastic_impact(0.4, 0.3e-3, Relaxes::deviator).restitution_momentum - 0.01);
}

TEST(ViscoelasticImpact, SlowBranchIsElasticWithTheInstantaneousModulus) {
  const FemResult elastic = viscoelastic_impact(0.0, 0.0, Relaxes::all);
  const FemResult slow = viscoelastic_impact(0.4, 1e3, Relaxes::all);
  EXPECT_NEAR(slow.scalars.peak_force / elastic.scalars.peak_force, 1.0, 1e-5);
  EXPECT_NEAR(slow.restitution_momentum, elastic.restitution_momentum, 1e-5);
}

TEST(ViscoelasticImpact, FastBranchIsElasticWithTheLongTermModulus) {
  FemProblem soft = with_branch(0.0, 0.0, Relaxes::all);
  soft.material.youngs_modulus *= 0.6;
  const FemResult elastic = test::checked_impact(viscoelastic_mesh(), soft);
  const FemResult fast = viscoelastic_impact(0.4, 1e-9, Relaxes::all);
  EXPECT_NEAR(fast.scalars.peak_force / elastic.scalars.peak_force, 1.0, 5e-3);
  EXPECT_NEAR(fast.scalars.peak_deflection / elastic.scalars.peak_deflection, 1.0, 1e-3);
  EXPECT_NEAR(fast.restitution_momentum, elastic.restitution_momentum, 1e-3);
}

TEST(ViscoelasticImpact, BothModulusBasesGiveTheSameImpact) {
  FemProblem long_term = with_branch(1.0, 0.3e-3, Relaxes::all);
  long_term.material.modulus = ModulusBasis::long_term;
  long_term.material.youngs_modulus = 5e6;
  const FemResult a = test::checked_impact(viscoelastic_mesh(), long_term);
  const FemResult b = viscoelastic_impact(0.5, 0.3e-3, Relaxes::all);
  EXPECT_NEAR(a.scalars.peak_force / b.scalars.peak_force, 1.0, 1e-9);
  EXPECT_NEAR(a.restitution_momentum, b.restitution_momentum, 1e-9);
}

TEST(ViscoelasticImpact, ElasticFormsAgreeAtSmallStrainAlone) {
  const auto off = [](double speed) {
    FemProblem problem = test::common_case(speed);
    const FemResult a = test::checked_impact(viscoelastic_mesh(), problem);
    problem.material.elastic = ElasticModel::neo_hookean_isochoric;
    const FemResult b = test::checked_impact(viscoelastic_mesh(), problem);
    return std::abs(b.scalars.peak_force / a.scalars.peak_force - 1.0);
  };
  EXPECT_LT(off(0.1), 5e-4);
  EXPECT_GT(off(15.0), 2e-3);
}

}  // namespace
}  // namespace rebound
