// Factors of strain, against their points, their energy and what they dissipate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/materials/strain_factor.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

StrainFactor factor(double a, double b, double c, double d) {
  return {.stiffening = a, .softening = b, .densification = c, .mullins = d, .youngs_modulus = 2.8};
}

/// A factor with a curve beside: two bends, 1 + g between 0.8 and 1.5.
StrainFactor with_curve(StrainFactor k) {
  k.curve = {.act = true,
             .at_zero = -0.1,
             .place = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5},
             .change = {-1.0, 3.0, 1.0, -2.0, 2.0, -3.0},
             .steepest = 3.0};
  return k;
}

/// Unloading runs through −0.5, −0.1, −0.2 and zero, so that it bends both ways.
StrainFactor with_unloading(StrainFactor k) {
  k.unloading = {.act = true,
                 .at_zero = -0.5,
                 .place = {0.0, 0.4, 0.6, 0.8, 0.9},
                 .change = {1.0, -1.5, 1.0, 0.0, 0.0},
                 .steepest = 1.0};
  return k;
}

/// f is the derivative of Ψ in W at a fixed largest strain, loading or not.
TEST(StrainFactorTest, FactorIsDerivativeOfEnergy) {
  for (const auto& k :
       {factor(2, 0, 0, 0), factor(0, 0.6, 0, 0), factor(0, 0, 30, 0), factor(0, 0, 0, 0.5),
        factor(1, 0.3, 20, 0.4), with_curve(factor(0, 0, 0, 0)),
        with_curve(factor(1, 0.3, 20, 0.4)), with_unloading(factor(0, 0, 0, 0)),
        with_unloading(with_curve(factor(1, 0.3, 20, 0.4)))})
    for (const double strain : {0.01, 0.23, 0.3, 0.7})
      for (const double largest : {1.0, 1.5}) {
        const double w = 0.5 * 2.8 * strain * strain;
        const auto energy = [&](double x) {
          auto at = factor_at(k, x, largest);
          return factored_energy(k, at);
        };
        const double h = 1e-5 * w;
        EXPECT_NEAR((energy(w + h) - energy(w - h)) / (2 * h) / factor_at(k, w, largest).value, 1.0,
                    1e-6)
            << strain;
      }
}

/// The bends of a material's curves pass through its points.
TEST(StrainFactorTest, CurvesPassThroughTheirPoints) {
  Material material;
  material.youngs_modulus = 2.8;
  material.strain.curve = {.value = {0.1, -0.2, 0.3, 0.0, 0.4, 0.2}, .reach = 0.5};
  const StrainFactor k = viscoelastic_constants(material).inelastic.factor;
  for (int i = 0; i < 7; ++i) {  // flat beyond the last
    const double strain = 0.1 * i, w = 0.5 * k.youngs_modulus * strain * strain;
    EXPECT_NEAR(factor_at(k, w, 0.0).value - 1.0, material.strain.curve.value[std::min(i, 5)],
                1e-12);
  }
  material.strain = {};
  material.strain.unloading.value = {-0.5, -0.3, -0.4, -0.1, -0.05};
  const StrainFactor m = viscoelastic_constants(material).inelastic.factor;
  for (int i = 0; i < 6; ++i) {
    const double share = 1.0 - (1.0 - 0.2 * i) * (1.0 - 0.2 * i), strain = 0.3 * share;
    const double w = 0.5 * m.youngs_modulus * strain * strain;
    EXPECT_NEAR(factor_at(m, w, 0.3).value - 1.0, i < 5 ? material.strain.unloading.value[i] : 0.0,
                1e-12);
  }
}

TEST(StrainFactorTest, NothingAtRestAndOnFirstLoading) {
  EXPECT_NEAR(factor_at(factor(3, 0.5, 40, 0.5), 0.0, 0.0).value, 1.0, 1e-15);
  EXPECT_NEAR(
      factored_energy(factor(3, 0.5, 40, 0.5), factor_at(factor(3, 0.5, 40, 0.5), 0.0, 0.0)), 0.0,
      1e-18);
  EXPECT_DOUBLE_EQ(factor_at(factor(0, 0, 0, 0.5), 0.3, 0.1).value, 1.0);  // ε above 0.1
  // The formula of the effects, unloading to half the largest strain.
  const double w = 0.5 * 2.8 * 0.2 * 0.2;
  EXPECT_NEAR(factor_at(factor(0, 0, 0, 0.5), w, 0.4).value, 1.0 - 0.5 * (1.0 - 0.5), 1e-15);
}

TEST(StrainFactorTest, WorkIsStoredAndSoftened) {
  // ∫ f dW over loading, unloading, farther loading and release.
  for (const auto& k : {factor(0, 0, 0, 0.5), factor(2, 0.4, 30, 0.7), factor(1, 0, 0, 0),
                        with_curve(factor(0, 0, 0, 0.5)), with_unloading(factor(0, 0.4, 0, 0)),
                        with_unloading(with_curve(factor(0, 0, 0, 0.3)))}) {
    double work = 0.0, largest = 0.0, before = 0.0, force = 1.0;
    const double ends[] = {0.0, 0.3, 0.05, 0.5, 0.0};
    for (int leg = 0; leg < 4; ++leg)
      for (int i = 1; i <= 20000; ++i) {
        const double strain = ends[leg] + (ends[leg + 1] - ends[leg]) * i / 20000.0;
        const double w = 0.5 * 2.8 * strain * strain;
        const auto at = factor_at(k, w, largest);
        work += 0.5 * (force + at.value) * (w - before);
        largest = at.largest_strain;
        force = at.value;
        before = w;
        if (i % 5000 != 0) continue;
        EXPECT_NEAR(work, factored_energy(k, at) + softened_energy(k, at), 1e-7) << leg << i;
      }
  }
}

/// −∂Ψ/∂ε_m ≥ 0: what is softened is lost.
TEST(StrainFactorTest, SofteningDissipates) {
  test::Random random(66);
  for (int i = 0; i < 500; ++i) {
    const auto k = factor(random.between(0, 3), random.between(0, 0.9), random.between(0, 50),
                          random.between(0, 0.99));
    const double strain = random.between(0.0, 0.6), largest = strain + random.between(0.0, 0.5);
    const double w = 0.5 * 2.8 * strain * strain;
    EXPECT_LE(factored_energy(k, factor_at(k, w, largest + 0.01)),
              factored_energy(k, factor_at(k, w, largest)) + 1e-15);
    EXPECT_GE(factored_energy(k, factor_at(k, w, largest)), -1e-15);
  }
}

}  // namespace
}  // namespace rebound::fem
