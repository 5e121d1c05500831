// The viscous stress, against its closed form and its power.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/materials/viscous_stress.hpp"
#include "tests/unit/fem/materials/deformation_states.hpp"

namespace rebound::fem {
namespace {

TEST(ViscousStressTest, SmallStrain) {
  const State rate{0.3, 0.5, -0.1, -0.7, 0.2};
  const auto s = viscous_stress(strain_of(rest), rest, rate, moduli, 0.25);
  const double trace = rate.rr + rate.zz + rate.tt, lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  EXPECT_DOUBLE_EQ(s.rr, 0.25 * (2 * moduli.shear * rate.rr + lame * trace));
  EXPECT_DOUBLE_EQ(s.zz, 0.25 * (2 * moduli.shear * rate.zz + lame * trace));
  EXPECT_DOUBLE_EQ(s.tt, 0.25 * (2 * moduli.shear * rate.tt + lame * trace));
  EXPECT_DOUBLE_EQ(s.rz, 0.25 * moduli.shear * (rate.rz + rate.zr));
}

TEST(ViscousStressTest, PowerIsTheNormOfTheRateAndBounded) {
  test::Random random(65);
  for (int i = 0; i < 300; ++i) {
    const State f = moved(rest, 0.5, random_direction(random));
    if (jacobian_of(f) < 0.2 || f.tt < 0.2) continue;
    const State rate = random_direction(random);
    const auto e = strain_of(f);
    const double power = product(first_piola(f, viscous_stress(e, f, rate, moduli, 1.0)), rate);
    // l = Ḟ F⁻¹
    const double det = f.rr * f.zz - f.rz * f.zr;
    const double lrr = (rate.rr * f.zz - rate.rz * f.zr) / det,
                 lrz = (rate.rz * f.rr - rate.rr * f.rz) / det;
    const double lzr = (rate.zr * f.zz - rate.zz * f.zr) / det,
                 lzz = (rate.zz * f.rr - rate.zr * f.rz) / det;
    const double ltt = rate.tt / f.tt, trace = lrr + lzz + ltt, off = 0.5 * (lrz + lzr);
    const double expected = 2 * moduli.shear * (lrr * lrr + lzz * lzz + ltt * ltt + 2 * off * off) +
                            (moduli.bulk - 2.0 / 3.0 * moduli.shear) * trace * trace;
    EXPECT_NEAR(power / expected, 1.0, 1e-11);
    EXPECT_GT(power, 0.0);
    const double m =
        std::max(e.inverse.tt, 0.5 * (e.inverse.rr + e.inverse.zz) +
                                   std::hypot(0.5 * (e.inverse.rr - e.inverse.zz), e.inverse.rz));
    EXPECT_LT(power,
              damping_growth(e, m, moduli) * 3.0 * moduli.bulk * product(rate, rate) * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace rebound::fem
