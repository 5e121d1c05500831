// Stress, tangent and branches of the implicit scheme at one point.
#include "fem/implicit/point_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using test::elastic_models;
using test::Random;
using test::unit_material;

Symmetric<double> strained(Random& random, double size) {
  return {1.0 + size * random(), 1.0 + size * random(), 1.0 + size * random(),
          0.5 * size * random()};
}

Eigen::Vector4d vector_of(const Symmetric<double>& s) {
  return {s.rr, s.zz, s.tt, s.rz};
}

Material with_branches(ElasticModel model) {
  Material material = unit_material(model);
  material.branches = {{0.3, 0.4, Relaxes::all}, {0.2, 2.0, Relaxes::deviator}};
  return material;
}

TEST(PointLawTest, TangentIsTheDerivativeOfTheStress) {
  for (const auto model : elastic_models) {
    PointLaw law(with_branches(model));
    law.set_step(0.7);
    Random random(11);
    std::vector<BranchState> states(2);
    law.accept(strained(random, 0.3), states.data());
    const auto c = strained(random, 0.4);
    const StressResponse at = law.respond(c, states.data());
    EXPECT_LT((at.stress - vector_of(law.stress(c, states.data()))).norm(), 1e-14);
    EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-13 * at.tangent.norm());
    const auto e = strained(random, 1.0);  // direction
    const Eigen::Vector4d strain(0.5 * e.rr, 0.5 * e.zz, 0.5 * e.tt,
                                 e.rz);  // E = C/2, 2 E_rz = C_rz
    const auto remainder = [&](double h) {
      const Symmetric<double> moved{c.rr + h * e.rr, c.zz + h * e.zz, c.tt + h * e.tt,
                                    c.rz + h * e.rz};
      return (vector_of(law.stress(moved, states.data())) - at.stress - h * at.tangent * strain)
          .norm();
    };
    EXPECT_NEAR(test::smallest_slope(remainder, 1e-2), 2.0, 0.1);
  }
}

TEST(PointLawTest, SmallStrainIsIsotropicElasticity) {
  for (const auto model : elastic_models) {
    const PointLaw law(unit_material(model));  // μ = 1, λ = 4
    const auto at = law.respond({1.0, 1.0, 1.0, 0.0}, nullptr);
    EXPECT_LT(at.stress.norm(), 1e-15);
    Eigen::Matrix4d expected;
    expected << 6, 4, 4, 0, 4, 6, 4, 0, 4, 4, 6, 0, 0, 0, 0, 1;
    EXPECT_LT((at.tangent - expected).norm(), 1e-13);
  }
}

// A held strain: the branch falls as exp(−t/τ), whatever the steps.
TEST(PointLawTest, HeldStrainRelaxesExactly) {
  Material material = unit_material();
  material.branches = {{0.4, 0.5, Relaxes::all}};
  PointLaw law(material), elastic(unit_material());
  const Symmetric<double> c{1.2, 0.9, 1.1, 0.1};
  const double instantaneous = vector_of(elastic.stress(c, nullptr)).norm();
  std::vector<BranchState> states(1);
  law.set_step(1e-12);  // a jump
  law.accept(c, states.data());
  double time = 0.0;
  for (const double step : {0.1, 0.3, 0.05, 1.0}) {
    law.set_step(step);
    time += step;
    const double now = vector_of(law.stress(c, states.data())).norm();
    EXPECT_NEAR(now / instantaneous, 0.6 + 0.4 * std::exp(-time / 0.5), 1e-11);
    law.accept(c, states.data());
  }
  law.set_step(std::numeric_limits<double>::infinity());
  EXPECT_NEAR(vector_of(law.stress(c, states.data())).norm() / instantaneous, 0.6, 1e-14);
}

}  // namespace
}  // namespace rebound::fem
