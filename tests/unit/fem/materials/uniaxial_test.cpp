#include "fem/materials/uniaxial.hpp"
#include "fem/interface/elastic_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/error.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

TEST(UniaxialTest, HyperfoamOfOneBeta) {
  Material foam{.elastic = ElasticModel::hyperfoam,
                .youngs_modulus = 3e6,
                .poisson_ratio = 0.25,
                .terms = {{.weight = 1.0, .exponent = 6.0}}};
  for (const auto& state : uniaxial_states(foam, {0.3, 0.7, 1.0, 1.5})) {
    const double mu = 3e6 / 2.5, lateral = std::pow(state.stretch, -0.25);
    EXPECT_NEAR(state.lateral_stretch / lateral, 1.0, 1e-12);
    const double expected =
        mu / 3.0 / state.stretch *
        (std::pow(state.stretch, 6.0) - std::pow(state.stretch * lateral * lateral, -6.0 * 0.5));
    EXPECT_NEAR(state.nominal_stress, expected, 1e-9 * 3e6);
  }
}

/// Every law starts at its modulus and Poisson ratio, relaxed as far as it can.
TEST(UniaxialTest, SmallStrainIsTheModulus) {
  for (const ElasticModel elastic : test::elastic_models) {
    Material material = test::unit_material(elastic);
    material.branches = {{0.4, 1.0, Relaxes::all}};
    material.strain = {.stiffening = 3.0, .softening = 0.5, .densification = 2.0, .mullins = 0.5};
    const auto states = uniaxial_states(material, {1.0 - 1e-7, 1.0 + 1e-7});
    EXPECT_NEAR((states[1].nominal_stress - states[0].nominal_stress) / 2e-7, 0.6 * 2.8, 1e-5);
    EXPECT_NEAR((states[0].lateral_stretch - states[1].lateral_stretch) / 2e-7, 0.4, 1e-5);
  }
}

TEST(UniaxialTest, RefusesWhatIsNoStretch) {
  for (const double stretch : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(uniaxial_states(test::unit_material(), {stretch}), Error);
}

}  // namespace
}  // namespace rebound::fem
