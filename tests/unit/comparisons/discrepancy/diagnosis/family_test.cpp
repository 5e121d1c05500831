// An effect that is in no formula of the list: its family is said, with the curve, and no name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/repeated_shots.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_search.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::believed_law;
using testing::diagnose_hidden;
using testing::experiment_with;

/// An elastic force with a bulge at half the largest deflection: stiffer, then as it was.
EffectChoice bulge() {
  return {"elastic-curve",
          0.0,
          {{"at_0", 0.0},
           {"at_1", 0.0},
           {"at_2", 0.04},
           {"at_3", 0.04},
           {"at_4", 0.0},
           {"reach", 0.4},
           {"damping_share", 0.0}}};
}

TEST(FamilyTest, ABulgeInTheElasticForceIsOfTheElasticFamily) {
  int right = 0, wrong = 0;
  constexpr int seeds = 5;
  for (int seed = 0; seed < seeds; ++seed) {
    const Diagnosis d = diagnose_hidden(experiment_with({bulge()}, 80 + seed));
    right += d.verdict == DiagnosisVerdict::family && d.family == EffectFamily::elastic;
    wrong += d.verdict == DiagnosisVerdict::missing ||
             (d.verdict == DiagnosisVerdict::family && d.family != EffectFamily::elastic);
    if (d.verdict != DiagnosisVerdict::family) continue;
    ASSERT_FALSE(d.curves.empty());
    const FactorBand& band = d.curves.front();
    EXPECT_EQ(band.of, "deflection_over_radius");
    // Stiffness and the level of the curve are one number: the band is that of the shape, and would
    // be ten times as wide with the level in it.
    EXPECT_LT(band.high[2] - band.low[2], 0.1);
    EXPECT_LT(*d.gap.after - 1.0, 0.2 * (*d.gap.before - 1.0));
  }
  EXPECT_GE(right, 4);
  EXPECT_EQ(wrong, 0);
}

/// A plate on a frame, both with a damping ratio of 0.08: their ringing fades within a contact, so
/// that no second line shows after it.
TEST(FamilyTest, AFrameWhoseRingingFadesAtOnceIsOfTheDynamics) {
  constexpr int seeds = 3;
  for (int seed = 0; seed < seeds; ++seed) {
    SynthesisFile file = experiment_with({{"plate-on-frame",
                                           3e-9,
                                           {{"mass", 0.8},
                                            {"damping_ratio", 0.08},
                                            {"frame_stiffness_ratio", 0.8},
                                            {"frame_mass_ratio", 4.5}}}},
                                         90 + seed);
    file.instrument.force_noise = 5.0;
    const Diagnosis d = diagnose_hidden(file);
    EXPECT_EQ(d.verdict, DiagnosisVerdict::family) << seed;
    EXPECT_EQ(d.family, EffectFamily::dynamics) << seed;
    EXPECT_LT(*d.gap.after, 1.3) << seed;
  }
}

/// A pull that grows with the deflection, is larger on the way back, and lets go a tenth of the
/// reach beyond the plate.
EffectChoice sticky_surface() {
  return {"pull-curves",
          0.03,
          {{"way_in_2", 0.006},
           {"way_in_5", 0.01},
           {"way_back_1", 0.025},
           {"way_back_2", 0.02},
           {"way_back_3", 0.01},
           {"way_back_4", 0.004},
           {"reach", 0.3},
           {"gap_over_reach", 0.1}}};
}

TEST(FamilyTest, APullBeyondThePlateIsOfTheSurfaceFamily) {
  int right = 0, wrong = 0;
  for (const int seed : {21, 22, 23}) {
    const Diagnosis d = diagnose_hidden(experiment_with({sticky_surface()}, seed));
    right += d.verdict == DiagnosisVerdict::family && d.family == EffectFamily::surface;
    wrong += d.verdict == DiagnosisVerdict::missing || d.family != EffectFamily::surface;
  }
  EXPECT_GE(right, 2);
  EXPECT_EQ(wrong, 0);
}

/// No formula of a pull is that of this surface, and no set of formulas takes its place.
TEST(FamilyTest, APullBesideAPlateIsSaidWithThePlate) {
  const EffectChoice plate{"plate-compliance", 1e-8, {{"mass", 0.5}, {"damping_ratio", 0.03}}};
  int both = 0;
  for (const int seed : {41, 42, 43}) {
    const Diagnosis d = diagnose_hidden(experiment_with({plate, sticky_surface()}, seed));
    const std::vector<std::vector<std::string>> names{{"plate-compliance", "pull-curves"}};
    both += d.candidates == names;
  }
  EXPECT_GE(both, 2);
}

/// Two effects, neither of which obeys a formula of the list.
TEST(FamilyTest, APullBesideABulgeIsSaidWithTheBulge) {
  const EffectNames names{"elastic-curve", "pull-curves"};
  int both = 0;
  for (const int seed : {51, 52, 53}) {
    const Diagnosis d = diagnose_hidden(experiment_with({bulge(), sticky_surface()}, seed));
    EXPECT_NE(d.verdict, DiagnosisVerdict::missing);
    both += std::any_of(d.candidates.begin(), d.candidates.end(), [&](const auto& one) {
      return EffectNames(one.begin(), one.end()) == names;
    });
  }
  EXPECT_GE(both, 2);
}

/// A curve beside a mass inside follows anything: the pair is no answer, not even where it is true.
TEST(FamilyTest, AMassInsideBesideACurveIsNoAnswer) {
  const auto bends = [](const std::string& one, const std::string& other) {
    return are_hidden_mass_and_curve(find_effect(one).card, find_effect(other).card);
  };
  EXPECT_TRUE(bends("internal-mode", "unloading-curve"));
  EXPECT_TRUE(bends("elastic-curve", "internal-mode"));
  EXPECT_FALSE(bends("internal-mode", "relaxation-spectrum"));
  EXPECT_FALSE(bends("plate-compliance", "unloading-curve"));
  const EffectChoice mass{"internal-mode", 0.1, {{"frequency", 3000.0}, {"damping_ratio", 0.05}}};
  for (const int seed : {61, 62}) {
    const Diagnosis d = diagnose_hidden(experiment_with({bulge(), mass}, seed));
    for (const auto& names : d.candidates) {
      const EffectNames set(names.begin(), names.end());
      EXPECT_FALSE(set.contains("internal-mode") && set.contains("elastic-curve")) << seed;
    }
  }
}

// What a diagnosis looks for is measured in the ball and its contact, not in kilograms.
TEST(FamilyTest, APlateUnderASmallBallIsFound) {
  for (const int seed : {31, 32}) {
    SynthesisFile file = experiment_with(
        {{"plate-compliance", 1e-8, {{"mass", 0.012}, {"damping_ratio", 0.03}}}}, seed);
    file.sphere = {.mass = 5e-3, .diameter = 20e-3};
    file.mass_uncertainty = 1e-5;
    file.instrument.force_noise = 1.0;
    const Diagnosis d = diagnose_hidden(file);
    EXPECT_EQ(d.family, EffectFamily::dynamics);
    EXPECT_TRUE(std::any_of(d.candidates.begin(), d.candidates.end(), [](const auto& names) {
      return names == std::vector<std::string>{"plate-compliance"};
    }));
  }
}

// A straight line between impacts that are one per cent apart, two per cent away.
TEST(RepeatedShotsTest, AShotBetweenTwoSpeedsIsTheirLine) {
  LumpedProblem problem{.sphere = {.mass = 89.6e-3, .diameter = 66.2e-3},
                        .impact = {.speed = 15.0},
                        .model = believed_law()};
  const auto run = [&] {
    const LumpedResult result = simulate_fast(problem);
    return ModelledImpact{.trace = result.trace, .scalars = result.scalars, .plate = {}};
  };
  const ModelledImpact nominal = run();
  problem.impact.speed = 15.15;
  const ModelledImpact above = run();
  problem.impact.speed = 15.3;
  const ModelledImpact exact = run(), line = between(nominal, above, 2.0);
  const double peak = exact.scalars.peak_force;
  for (std::size_t i = 0; i < exact.trace.time.size(); ++i) {
    EXPECT_NEAR(line.trace.force[i], exact.trace.force[i], 1e-4 * peak);
    EXPECT_NEAR(line.trace.time[i], exact.trace.time[i], 1e-4 * exact.scalars.contact_time);
  }
  EXPECT_NEAR(line.scalars.restitution, exact.scalars.restitution, 1e-4);
}

TEST(RepeatedShotsTest, OnlyThreeOrMoreNearOneSpeedShare) {
  Observations seen;
  for (const double speed : {10.0, 10.1, 9.9, 20.0, 20.1, 30.0}) {
    MeasuredImpact shot;
    shot.impact.speed = speed;
    seen.shots.push_back(shot);
  }
  const std::vector<std::size_t> expected{0, 0, 0, 3, 4, 5};
  EXPECT_EQ(shots_that_share(seen, believed_law()), expected);
  LumpedModel at_speeds = believed_law();
  at_speeds.damping_formula = "hertz-exact";
  EXPECT_EQ(shots_that_share(seen, at_speeds), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace rebound
