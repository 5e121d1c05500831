#include "lumped/laws/exact_restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

// e(p) by integration with 14 digits, and by the implicit relation in 34.
TEST(ExactRestitutionTest, HuntCrossleyTable) {
  const double table[][2] = {{0.1, 0.93747557994991}, {0.2, 0.88218998624731},
                             {0.3, 0.8328697922656},  {0.5, 0.74843493159743},
                             {0.6, 0.71195017957787}, {0.8, 0.64796742493272},
                             {1.0, 0.59362426004004}, {1.5, 0.48774125601535},
                             {2.0, 0.41071968606104}, {5.0, 0.19698024528052}};
  for (const auto& [p, e] : table) {
    EXPECT_NEAR(hunt_crossley_restitution(p) / e, 1.0, 1e-12) << p;
    EXPECT_NEAR(hunt_crossley_damping_number(e) / p, 1.0, 1e-12) << p;
  }
}

TEST(ExactRestitutionTest, HuntCrossleyLowLoss) {
  EXPECT_EQ(hunt_crossley_restitution(0.0), 1.0);
  for (double p : {1e-3, 1e-5, 1e-8, 1e-10}) {
    const double loss = 1.0 - hunt_crossley_restitution(p);
    EXPECT_NEAR(loss / p, 2.0 / 3.0 - 4.0 / 9.0 * p, 0.5 * p * p + 1e-15 / p) << p;
  }
}

TEST(ExactRestitutionTest, InversesReturn) {
  for (double e : {1e-6, 1e-3, 0.05, 0.3, 0.527, 0.9, 0.999, 0.999999}) {
    EXPECT_NEAR(hunt_crossley_restitution(hunt_crossley_damping_number(e)) / e, 1.0, 1e-9) << e;
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      const double zeta = kelvin_voigt_damping_ratio(e, rule);
      EXPECT_NEAR(kelvin_voigt_restitution(zeta, rule) / e, 1.0, 1e-9) << e;
    }
  }
}

// e under zero deflection and zero force; closed forms evaluated in 15 digits.
TEST(ExactRestitutionTest, KelvinVoigtTable) {
  const double table[][3] = {{0.01, 0.9690709040, 0.9692647505}, {0.05, 0.8544678930, 0.8587581018},
                             {0.1, 0.7292476143, 0.7440793977},  {0.2, 0.5266205993, 0.5717400276},
                             {0.5, 0.1630335348, 0.2984360592},  {0.9, 0.0015237558, 0.1552827475}};
  for (const auto& [zeta, deflection, force] : table) {
    EXPECT_NEAR(kelvin_voigt_restitution(zeta, SeparationRule::zero_deflection), deflection, 6e-11);
    EXPECT_NEAR(kelvin_voigt_restitution(zeta, SeparationRule::zero_force), force, 6e-11);
  }
}

TEST(ExactRestitutionTest, HalfPhaseIsSmoothThroughCriticalDamping) {
  for (double d : {0.99e-4, 1.01e-4, -0.99e-4, -1.01e-4}) {
    const double y = d;  // θ/sin θ expanded in 1 − ζ, one term beyond the one in use
    const double series = 1.0 + y / 3.0 + 2.0 * y * y / 15.0 + 2.0 * y * y * y / 35.0;
    EXPECT_NEAR(kelvin_voigt_half_phase(1.0 - d), series, 1e-12);
  }
}

TEST(ExactRestitutionTest, RefusesWhatHasNoAnswer) {
  EXPECT_THROW(hunt_crossley_restitution(-0.1), Error);
  EXPECT_THROW(hunt_crossley_restitution(std::nan("")), Error);
  for (double e : {0.0, -0.5, 1.5, std::nan("")}) {
    EXPECT_THROW(hunt_crossley_damping_number(e), Error);
    EXPECT_THROW(kelvin_voigt_damping_ratio(e, SeparationRule::zero_force), Error);
  }
  try {
    kelvin_voigt_restitution(1.0, SeparationRule::zero_deflection);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::solver_failed);
  }
}

}  // namespace
}  // namespace rebound
