// A number that a model chooses where nothing states it.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/inference/calibration/effect_unknowns.hpp"

namespace rebound {
namespace {

/// Left out, the range of the pull is chosen by FE; stated, it is one more unknown there.
TEST(NumberLeftOpenTest, IsNoUnknown) {
  const EffectChoice open{"adhesion", 50.0, {}},
      stated{"adhesion", 50.0, {{"range_over_radius", 0.05}}};
  std::vector<CalibrationParameter> none, in_fem, in_lumped;
  EXPECT_EQ(EffectUnknowns({open}, true, none).places(0).size(), 1u);
  const EffectUnknowns range({stated}, true, in_fem);
  ASSERT_EQ(range.places(0).size(), 2u);
  EXPECT_NEAR(range.at({60.0, std::log(0.07)})[0].parameters.at("range_over_radius"), 0.07, 1e-12);
  EXPECT_EQ(EffectUnknowns({stated}, false, in_lumped).places(0).size(), 1u);
}

}  // namespace
}  // namespace rebound
