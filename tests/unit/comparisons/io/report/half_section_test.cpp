#include "comparisons/io/report/half_section.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/report/packed_values.hpp"
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

/// One cell at two instants, and as many more as a range needs.
ShapeHistory with_fields(int frames) {
  ShapeHistory shapes{.cells = {{0, 1, 2, 3}},
                      .time = {},
                      .positions = {},
                      .fields = {},
                      .contact_vertices = {0, 1},
                      .contact_pressure = {}};
  ShapeField stress{.quantity = ShapeQuantity::von_mises, .values = {}};
  ShapeField pressure{.quantity = ShapeQuantity::pressure, .values = {}};
  for (int i = 0; i < frames; ++i) {
    shapes.time.push_back(1e-3 * i);
    shapes.positions.push_back({{0, 0}, {0.01, 0}, {0.01, 0.02}, {0, 0.02}});
    stress.values.push_back({static_cast<float>(1e6 * i)});
    pressure.values.push_back({static_cast<float>(-2e6 + 1e6 * i)});
    shapes.contact_pressure.push_back({static_cast<float>(1234567.0 * i), 0.0f});
  }
  shapes.fields = {stress, pressure};
  return shapes;
}

TEST(HalfSection, FieldsHaveUnitsAndOneRangeForAllFrames) {
  const Animation animation = half_section(with_fields(4), "title", "caption");
  ASSERT_EQ(animation.fields.size(), 2u);
  EXPECT_TRUE(animation.caption.starts_with("caption Each cell"));
  EXPECT_EQ(animation.fields[0].name, "von Mises stress");
  EXPECT_EQ(animation.fields[0].unit, "MPa");
  EXPECT_EQ(animation.fields[0].low, 0.0);
  EXPECT_EQ(animation.fields[0].high, 3.0);
  EXPECT_EQ(animation.fields[0].values[2], (std::vector<float>{2.0f}));
  EXPECT_EQ(animation.fields[1].low, -2.0);
  EXPECT_EQ(animation.fields[1].high, 1.0);
  EXPECT_EQ(animation.contact.unit, "MPa");
  EXPECT_EQ(animation.contact.pressure[1], (std::vector<double>{1.235, 0.0}));
}

TEST(HalfSection, OneValueInAThousandDoesNotSetTheColours) {
  ShapeHistory shapes = with_fields(2000);
  for (auto& row : shapes.fields[0].values) row = {1e6f};
  shapes.fields[0].values[7] = {1e9f};
  EXPECT_EQ(half_section(shapes, "title", "caption").fields[0].high, 1.0);
}

TEST(HalfSection, RoundingBelowZeroIsNoRange) {
  ShapeHistory shapes = with_fields(4);
  shapes.fields[0].values[0] = {-1e-9f};
  EXPECT_EQ(half_section(shapes, "title", "caption").fields[0].low, 0.0);
}

TEST(HalfSection, AFieldOfZerosStillHasARange) {
  ShapeHistory shapes = with_fields(3);
  for (auto& row : shapes.fields[0].values) row = {0.0f};
  const AnimationField field = half_section(shapes, "title", "caption").fields[0];
  EXPECT_GT(field.high, field.low);
}

TEST(PackedValues, AreBytesOfTheRangeInBase64) {
  // 0, 255, 128, 0 and 255 beyond the ends: AP+AAP8=
  EXPECT_EQ(packed_values({{-1.0f, 1.0f}, {0.0f, -9.0f, 9.0f}}, {.low = -1.0, .high = 1.0}),
            "AP+AAP8=");
  EXPECT_EQ(packed_values({{1.0f}}, {.low = 0.0, .high = 1.0}), "/w==");
  EXPECT_EQ(packed_values({}, {}), "");
}

TEST(HalfSection, RefusesAnImpactThatKeptNoShapes) {
  EXPECT_THROW(half_section({}, "title", "caption"), Error);
}

}  // namespace
}  // namespace rebound::report
