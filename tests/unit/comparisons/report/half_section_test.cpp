#include "comparisons/report/half_section.hpp"

#include <gtest/gtest.h>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

TEST(HalfSection, IsInMillimetresAndMilliseconds) {
  const ShapeHistory shapes{.cells = {{0, 1, 2, 3}},
                            .time = {0.0, 1.5e-3},
                            .positions = {{{0, 0}, {0.01, 0}, {0.01, 0.02}, {0, 0.02}},
                                          {{0, 0}, {0.0112345678, 0}, {0.011, 0.018}, {0, 0.018}}}};
  const Animation animation = half_section(shapes, "title", "caption");
  EXPECT_EQ(animation.cells, shapes.cells);
  EXPECT_DOUBLE_EQ(animation.frames[1].time, 1.5);
  EXPECT_EQ(animation.frames[1].radius, (std::vector<double>{0.0, 11.235, 11.0, 0.0}));
  EXPECT_EQ(animation.frames[1].height, (std::vector<double>{0.0, 0.0, 18.0, 18.0}));
}

TEST(HalfSection, RefusesAnImpactThatKeptNoShapes) {
  EXPECT_THROW(half_section({}, "title", "caption"), Error);
}

}  // namespace
}  // namespace rebound::report
