// A number that a model chooses where nothing states it.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/effect_unknowns.hpp"

namespace rebound {
namespace {

/// Left out, FE chooses the range of the pull, and no neck holds a lumped ball; stated, it is one
/// more unknown of both.
TEST(NumberLeftOpenTest, IsNoUnknown) {
  const EffectChoice open{"adhesion", 50.0, {}},
      stated{"adhesion", 50.0, {{"range_over_radius", 0.05}}};
  std::vector<CalibrationParameter> none, in_fem, in_lumped;
  for (const bool of_fem : {true, false})
    EXPECT_EQ(EffectUnknowns({open}, of_fem, none).places(0).size(), 1u);
  const EffectUnknowns range({stated}, true, in_fem);
  ASSERT_EQ(range.places(0).size(), 2u);
  EXPECT_NEAR(range.at({60.0, std::log(0.07)})[0].parameters.at("range_over_radius"), 0.07, 1e-12);
  EXPECT_EQ(EffectUnknowns({stated}, false, in_lumped).places(0).size(), 2u);
}

/// No spectrum of relaxation times softens with rate; the lumped exponent may.
TEST(RangeInFemTest, BoundsTheSearchesThereAlone) {
  const EffectChoice softer{"rate-stiffening", -0.001, {}};
  std::vector<CalibrationParameter> in_fem, in_lumped;
  const EffectUnknowns of_fem({softer}, true, in_fem), of_law({softer}, false, in_lumped);
  ASSERT_EQ(in_fem.size(), 1u);
  EXPECT_GT(in_fem[0].lowest, 0.0);
  EXPECT_GE(in_fem[0].start, in_fem[0].lowest);
  EXPECT_LT(in_fem[0].highest, 1.0);
  EXPECT_EQ(in_lumped[0].start, -0.001);
}

}  // namespace
}  // namespace rebound
