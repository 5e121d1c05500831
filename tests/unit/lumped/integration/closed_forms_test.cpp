#include "lumped/integration/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr Approach unit{.mass = 1.0, .speed = 1.0};

// ωₙ t_c under zero deflection and zero force, ten ζ; closed forms evaluated
// independently in 15 digits, printed with 10.
TEST(ClosedFormsTest, KelvinVoigtTable) {
  const double table[][3] = {
      {0.010, 3.1417497450, 3.1217484116}, {0.050, 3.1455270229, 3.0453600222},
      {0.100, 3.1574194170, 2.9560753247}, {0.136, 3.1710554462, 2.8956510773},
      {0.174, 3.1902579573, 2.8350592605}, {0.200, 3.2063745754, 2.7953544407},
      {0.300, 3.2932839419, 2.6544745638}, {0.500, 3.6275987285, 2.4183991523},
      {0.700, 4.3991096250, 2.2275622815}, {0.900, 7.2073078415, 2.0694529405}};
  for (const auto& [zeta, at_zero_deflection, at_zero_force] : table) {
    const KelvinVoigtImpact impact({.stiffness = 1.0, .damping = 2.0 * zeta}, unit);
    EXPECT_NEAR(impact.contact_time(SeparationRule::zero_deflection), at_zero_deflection, 6e-11);
    EXPECT_NEAR(impact.contact_time(SeparationRule::zero_force), at_zero_force, 6e-11);
  }
}

// The trace satisfies its own definitions at the end of contact, for under-,
// critically and overdamped contacts.
TEST(ClosedFormsTest, KelvinVoigtTraceEndsAsItsRuleSays) {
  for (double zeta : {0.05, 0.5, 1.0, 1.0 + 1e-9, 2.0}) {
    const KelvinVoigtImpact impact({.stiffness = 3.0, .damping = 2.0 * zeta * std::sqrt(6.0)},
                                   {.mass = 2.0, .speed = 5.0});
    const auto rule = SeparationRule::zero_force;
    const ContactState end = impact.at(impact.contact_time(rule));
    EXPECT_NEAR(end.force, 0.0, 1e-12) << zeta;
    EXPECT_NEAR(-end.velocity / 5.0, impact.restitution(rule), 1e-12) << zeta;
    if (zeta >= 1.0) {
      EXPECT_THROW(impact.contact_time(SeparationRule::zero_deflection), Error);
      continue;
    }
    const ContactState back = impact.at(impact.contact_time(SeparationRule::zero_deflection));
    EXPECT_NEAR(back.deflection, 0.0, 1e-12) << zeta;
    EXPECT_NEAR(-back.velocity / 5.0, impact.restitution(SeparationRule::zero_deflection), 1e-12);
  }
}

// m = v = κ = 1: t_c = 3.21806545971904308, x_m, F_m to 15 digits.
TEST(ClosedFormsTest, HertzConstants) {
  const auto hertz = elastic_impact({.stiffness = 1.0, .damping = 0.0, .power = Power(1.5)}, unit);
  EXPECT_NEAR(hertz.contact_time, 3.21806545971904308, 1e-14);
  EXPECT_NEAR(hertz.peak_deflection, 1.09336207394327806, 1e-14);
  EXPECT_NEAR(hertz.peak_force, 1.14326262981832, 2e-14);
  EXPECT_NEAR(hertz.contact_time / hertz.peak_deflection, 2.94327518432465738, 1e-13);
  const auto spring = elastic_impact({.stiffness = 1.0, .damping = 0.0, .power = Power(1.0)}, unit);
  EXPECT_NEAR(spring.contact_time, std::numbers::pi, 1e-14);
}

// p: t_c, x_m, F_m, t(x_m) with m = v = κ = 1, n = 1.5, by integration with
// 13 digits.
TEST(ClosedFormsTest, HuntCrossleyTable) {
  const double table[][5] = {
      {0.1, 3.2401478124665, 1.0657086246096, 1.1044477989331, 1.584539709644},
      {0.5, 3.3382527559374, 0.97777032571708, 1.0382081796519, 1.5051902624722},
      {1.0, 3.475683527068, 0.8993899921196, 1.038991742422, 1.4322795281365},
      {2.0, 3.7802580375305, 0.79490761997159, 1.1042549942719, 1.33112133457},
      {5.0, 4.7978629204156, 0.63460979124336, 1.3325895033665, 1.1642295252941}};
  for (const auto& [p, contact_time, peak_deflection, peak_force, time_to_peak] : table) {
    const HuntCrossleyImpact impact({.stiffness = 1.0, .damping = p, .power = Power(1.5)}, unit);
    EXPECT_NEAR(impact.contact_time(), contact_time, 5e-12) << p;
    EXPECT_NEAR(impact.peak_deflection(), peak_deflection, 5e-13) << p;
    EXPECT_NEAR(impact.peak_force(), peak_force, 5e-13) << p;
    EXPECT_NEAR(impact.time_to_peak(), time_to_peak, 5e-12) << p;
  }
}

TEST(ClosedFormsTest, HuntCrossleyWithoutLossIsHertz) {
  const HuntCrossley law{.stiffness = 3.5e6, .damping = 1e-5 * 3.5e6 / 15.0, .power = Power(1.5)};
  const Approach approach{.mass = 0.0896, .speed = 15.0};
  const auto hertz = elastic_impact(law, approach);
  const HuntCrossleyImpact impact(law, approach);
  // The difference is of first order in p = 1e-5.
  EXPECT_NEAR(impact.peak_deflection() / hertz.peak_deflection, 1.0, 1e-5);
  EXPECT_NEAR(impact.peak_force() / hertz.peak_force, 1.0, 1e-5);
  EXPECT_NEAR(impact.contact_time() / hertz.contact_time, 1.0, 1e-5);
}

TEST(ClosedFormsTest, HuntCrossleyRefusesVanishingDamping) {
  EXPECT_THROW(HuntCrossleyImpact({.stiffness = 1.0, .damping = 0.0, .power = Power(1.5)}, unit),
               Error);
}

}  // namespace
}  // namespace rebound
