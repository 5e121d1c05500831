// What each elastic law reduces to, and what its source says of it.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include "fem/materials/with_elastic.hpp"
#include "tests/unit/fem/materials/deformation_states.hpp"

namespace rebound::fem {
namespace {

State random_state(test::Random& random) {
  for (;;) {
    const State f{1 + 0.5 * random(), 0.5 * random(), 0.5 * random(), 1 + 0.5 * random(),
                  1 + 0.5 * random()};
    if (jacobian_of(f) > 0.2 && f.tt > 0.2) return f;
  }
}

/// Largest difference of the components.
double off(const Symmetric<double>& a, const Symmetric<double>& b) {
  return std::max(
      {std::abs(a.rr - b.rr), std::abs(a.zz - b.zz), std::abs(a.tt - b.tt), std::abs(a.rz - b.rz)});
}
double size(const Symmetric<double>& a) {
  return off(a, {0, 0, 0, 0});
}

TEST(MaterialLimits, OgdenOfExponentTwoIsNeoHookean) {
  const Ogden ogden{moduli, {.count = 1, .shear = {moduli.shear}, .exponent = {2.0}}};
  const NeoHookeanIsochoric neo{moduli};
  test::Random random(51);
  for (int i = 0; i < 100; ++i) {
    const auto e = strain_of(random_state(random));
    const auto stress = neo.deviatoric_stress(e);
    EXPECT_LT(off(ogden.deviatoric_stress(e), stress), 1e-13 * (1.0 + size(stress)));
    EXPECT_NEAR(ogden.deviatoric_energy(e), neo.deviatoric_energy(e), 1e-13);
  }
}

TEST(MaterialLimits, MooneyRivlinIsOgden) {
  const MooneyRivlin mooney{moduli, 0.3};
  const Ogden ogden{
      moduli,
      {.count = 2, .shear = {0.7 * moduli.shear, 0.3 * moduli.shear}, .exponent = {2.0, -2.0}}};
  test::Random random(52);
  for (int i = 0; i < 100; ++i) {
    const auto e = strain_of(random_state(random));
    const auto stress = ogden.deviatoric_stress(e);
    EXPECT_LT(off(mooney.deviatoric_stress(e), stress), 1e-12 * (1.0 + size(stress)));
    EXPECT_NEAR(mooney.deviatoric_energy(e), ogden.deviatoric_energy(e), 1e-12);
    EXPECT_NEAR(mooney.stiffness_growth(e, 1.0), ogden.stiffness_growth(e, 1.0), 1e-12);
  }
}

/// Free sides at the lateral stretch λ^(−ν): S_lateral = 0 at any stretch.
TEST(MaterialLimits, HyperfoamKeepsItsPoissonRatio) {
  for (const double nu : {0.0, 0.1, 0.3}) {
    const Moduli m = Moduli::from_youngs(2.8, nu);
    const double beta = nu / (1.0 - 2.0 * nu);
    const Hyperfoam foam{m,
                         {.count = 2,
                          .shear = {0.4 * m.shear, 0.6 * m.shear},
                          .exponent = {8.0, -3.0},
                          .beta = {beta, beta}}};
    for (const double stretch : {0.3, 0.6, 0.95, 1.4}) {
      const double lateral = std::pow(stretch, -nu);
      const auto e = strain_of(State{lateral, 0, 0, stretch, lateral});
      const auto d = foam.deviatoric_stress(e), v = foam.volumetric_stress(e);
      EXPECT_LT(std::abs(d.rr + v.rr) + std::abs(d.tt + v.tt), 1e-12 * std::abs(d.zz + v.zz));
      // Nominal stress, the closed form.
      double nominal = 0.0;
      for (int i = 0; i < 2; ++i)
        nominal += 2.0 * foam.terms.shear[i] / foam.terms.exponent[i] / stretch *
                   (std::pow(stretch, foam.terms.exponent[i]) -
                    std::pow(stretch * lateral * lateral, -foam.terms.exponent[i] * beta));
      EXPECT_NEAR(stretch * (d.zz + v.zz) / nominal, 1.0, 1e-12);
    }
  }
}

Material of(ElasticModel elastic) {
  return test::unit_material(elastic);
}

/// Stress next to equal stretches, where the directions turn wildly and the
/// formulas change over from quotients to series.
TEST(MaterialLimits, StressIsContinuousAtEqualStretches) {
  for (const ElasticModel elastic : test::elastic_models)
    with_elastic(viscoelastic_constants(of(elastic)).elastic, [](const auto& law) {
      const auto at = [&](double apart) {
        const auto e = strain_of(State{0.8, apart, 0.3 * apart, 0.8 + 0.7 * apart, 1.1});
        const auto d = law.deviatoric_stress(e), v = law.volumetric_stress(e);
        return Symmetric<double>{d.rr + v.rr, d.zz + v.zz, d.tt + v.tt, d.rz + v.rz};
      };
      const auto equal = at(0.0);
      EXPECT_EQ(equal.rz, 0.0);
      const double slope = off(at(1e-4), equal) / 1e-4;
      for (double apart = 1e-4; apart > 1e-17; apart *= 0.3)
        EXPECT_LT(off(at(apart), equal), 1.01 * slope * apart + 1e-14) << apart;
      // Across both changes from series to quotient.
      for (double apart = 1e-3; apart < 0.2; apart *= 1.01)
        EXPECT_LT(off(at(apart * (1 + 1e-10)), at(apart)), 2e-10 * slope * apart + 1e-13) << apart;
      return 0;
    });
}

using Number = Eigen::AutoDiffScalar<Eigen::Matrix<double, 5, 1>>;

/// The tangent, taken by automatic differentiation, against differences of the
/// stress: at random states and where stretches are equal.
TEST(MaterialLimits, TangentByAutomaticDifferentiation) {
  test::Random random(54);
  for (const ElasticModel elastic : test::elastic_models)
    with_elastic(viscoelastic_constants(of(elastic)).elastic, [&](const auto& law) {
      const auto stress = [&]<class T>(const Gradient<T>& f) {
        const Strain<T> e = strain_of(f);
        const Symmetric<T> d = law.deviatoric_stress(e), v = law.volumetric_stress(e);
        return first_piola(f, Symmetric<T>{d.rr + v.rr, d.zz + v.zz, d.tt + v.tt, d.rz + v.rz});
      };
      for (int i = 0; i < 20; ++i) {
        State f = random_state(random);
        if (i == 0) f = {1, 0, 0, 1, 1};
        if (i == 1) f = {0.7, 0, 0, 0.7, 1.2};
        const double values[5] = {f.rr, f.rz, f.zr, f.zz, f.tt};
        Number x[5];
        for (int j = 0; j < 5; ++j) x[j] = Number(values[j], 5, j);
        const auto found = stress(Gradient<Number>{x[0], x[1], x[2], x[3], x[4]});
        for (int j = 0; j < 5; ++j) {
          double ahead[5], behind[5];
          for (int k = 0; k < 5; ++k) {
            ahead[k] = values[k] + (k == j ? 1e-6 : 0.0);
            behind[k] = values[k] - (k == j ? 1e-6 : 0.0);
          }
          const auto a = stress(State{ahead[0], ahead[1], ahead[2], ahead[3], ahead[4]});
          const auto b = stress(State{behind[0], behind[1], behind[2], behind[3], behind[4]});
          const double scale =
              1e-7 * (1.0 + std::abs(found.rr.derivatives()[j]) +
                      std::abs(found.zz.derivatives()[j]) + std::abs(found.tt.derivatives()[j]));
          EXPECT_NEAR(found.rr.derivatives()[j], (a.rr - b.rr) / 2e-6, scale) << i << " " << j;
          EXPECT_NEAR(found.rz.derivatives()[j], (a.rz - b.rz) / 2e-6, scale) << i << " " << j;
          EXPECT_NEAR(found.zr.derivatives()[j], (a.zr - b.zr) / 2e-6, scale) << i << " " << j;
          EXPECT_NEAR(found.zz.derivatives()[j], (a.zz - b.zz) / 2e-6, scale) << i << " " << j;
          EXPECT_NEAR(found.tt.derivatives()[j], (a.tt - b.tt) / 2e-6, scale) << i << " " << j;
        }
      }
      return 0;
    });
}

}  // namespace
}  // namespace rebound::fem
