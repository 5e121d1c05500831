// MuJoCo, discussion 3404: a contact that was tuned for a restitution of 0.75 recorded 0.820. Model
// and record stand in the repository that the discussion names, markov-studio-llc/
// markov-twin-fidelity-harness: models/bounce.xml and results/case2_bounce.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lumped/integration/closed_forms.hpp"

namespace rebound {
namespace {

using std::numbers::pi;

/// bounce.xml: a ball of 0.5 kg falls 1 m; solref="-284244.606751 -68.756024".
struct BounceModel {
  double stiffness = 284244.606751;  ///< of solref [1/s^2]
  double damping = 68.756024;        ///< of solref [1/s]
};

/// d(r) of solimp="0.998 0.9999 0.0002 0.5 2".
double impedance(double depth) {
  constexpr double lowest = 0.998, highest = 0.9999, width = 0.0002;
  const double x = std::min(1.0, depth / width);
  const double share = x <= 0.5 ? 2.0 * x * x : 1.0 - 2.0 * (1.0 - x) * (1.0 - x);
  return lowest + share * (highest - lowest);
}

/// Apexes above the plane, the drop first, as MuJoCo's documentation has it ("Computation",
/// constraint model; "Modeling", solver parameters), in steps of 0.2 ms for 6 s: a1 + d (b v + k r)
/// = (1 - d) a0 with b = damping/dmax and k = stiffness d/dmax^2, speed first, then position.
std::vector<double> apexes(const BounceModel& model) {
  constexpr double step = 2e-4, gravity = 9.81, highest = 0.9999, radius = 0.1;
  std::vector<double> found = {1.0};
  double z = 1.0 + radius, v = 0.0, before = z, last = z;  // rounds as the centre does
  for (int i = 0; i < 30'000; ++i) {
    double acceleration = -gravity;
    if (const double r = z - radius; r < 0.0) {
      const double d = impedance(-r);
      const double reference =
          -model.damping / highest * v - model.stiffness / (highest * highest) * d * r;
      acceleration += std::max(0.0, d * (reference + gravity));
    }
    v += step * acceleration;
    z += step * v;
    if (last > before && last >= z && last > 1.02 * radius) found.push_back(last - radius);
    before = last;
    last = z;
  }
  return found;
}

/// By the slope of ln(height), as the record was.
double fitted_restitution(const std::vector<double>& heights) {
  const auto count = static_cast<double>(heights.size());
  const double middle = (count - 1.0) / 2.0;
  double above = 0.0, below = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double n = static_cast<double>(i) - middle;
    above += n * std::log(heights[i]);
    below += n * n;
  }
  return std::exp(above / below / 2.0);
}

constexpr double mass = 0.5;

double zeta_for_three_quarters() {
  return -std::log(0.75) / std::hypot(pi, std::log(0.75));
}

// The record itself, bounce by bounce: the first to rounding, the later ones to what rounding
// becomes, for a touch a little later in its step bounces otherwise. All fifteen give 0.820, to
// within the scatter of the last eight.
TEST(MujocoRecordTest, IsReproducedBounceByBounce) {
  const std::vector<double> found = apexes({});
  const double recorded[] = {1.0,
                             0.6843220669254436,
                             0.4589374787781182,
                             0.3064458865708175,
                             0.20471500467822548,
                             0.13942555465188086,
                             0.09356542415818747,
                             0.06383067125745295};
  ASSERT_EQ(found.size(), 16u);
  EXPECT_NEAR(found[1], recorded[1], 1e-12);
  for (std::size_t i = 0; i < std::size(recorded); ++i)
    EXPECT_NEAR(found[i], recorded[i], 5e-6) << i;
  EXPECT_NEAR(fitted_restitution(found), 0.8200448673276696, 1e-3);
}

// The cause: stiffness and damping were derived as m omega^2 and 2 zeta m omega, in N/m and N s/m,
// and MuJoCo takes them per mass. A ball of 0.5 kg so gets sqrt(0.5) of the damping ratio. Of the
// 0.0700 by which the record misses, 0.0663 are that; cutting the tension adds 0.0068, and the
// steps (29 of them a contact, the touch anywhere in one, gravity) take the rest away.
TEST(MujocoRecordTest, MissesForNumbersThatAreNotPerMass) {
  const BounceModel model;
  const double zeta = model.damping / (2.0 * std::sqrt(model.stiffness));
  EXPECT_NEAR(zeta / zeta_for_three_quarters(), std::sqrt(mass), 1e-6);
  EXPECT_NEAR(kelvin_voigt_restitution(zeta_for_three_quarters(), SeparationRule::zero_deflection),
              0.75, 1e-9);
  EXPECT_NEAR(kelvin_voigt_restitution(zeta, SeparationRule::zero_deflection) - 0.75, 0.0663, 5e-5);
  EXPECT_NEAR(kelvin_voigt_restitution(zeta, SeparationRule::zero_force) -
                  kelvin_voigt_restitution(zeta, SeparationRule::zero_deflection),
              0.0068, 5e-5);
}

// Per mass, the same model and the same fit find 0.757, within a per cent of what was asked for.
TEST(MujocoRecordTest, PerMassItFindsWhatWasAskedFor) {
  const BounceModel right{.stiffness = BounceModel{}.stiffness / mass,
                          .damping = BounceModel{}.damping / mass};
  EXPECT_NEAR(fitted_restitution(apexes(right)), 0.757, 1e-3);
}

}  // namespace
}  // namespace rebound
