#include "fem/output/shape_recorder.hpp"

#include <gtest/gtest.h>

#include "fem/output/frame_clock.hpp"

namespace rebound::fem {
namespace {

const std::vector<std::array<double, 2>> corners = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}, {0.0, 2.0}};

ShapeHistory one_cell() {
  ShapeHistory shapes;
  shapes.cells = {{0, 1, 2, 3}};
  shapes.contact_vertices = {0, 1};
  return shapes;
}

TEST(FrameClockTest, IsNeverDueUnlessAsked) {
  const FrameClock clock(0, 1.0);
  EXPECT_FALSE(clock.is_due(0.0));
  EXPECT_FALSE(clock.is_due(1e9));
}

TEST(FrameClockTest, StartsAtRestAndGoesOnAtItsRate) {
  FrameClock clock(4, 1.0);
  std::vector<double> due;
  for (int step = 0; step <= 200; ++step)
    if (clock.is_due(0.01 * step)) {
      due.push_back(0.01 * step);
      clock.tick();
    }
  ASSERT_EQ(due.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(due[i], 0.25 * static_cast<double>(i), 1e-2);
}

TEST(ShapeRecorder, AddsDisplacementsAndKeepsFields) {
  ShapeRecorder recorder(one_cell(), corners);
  const std::vector<double> none(8, 0.0), pressure = {7.0, 5.0, 0.0, 0.0};
  std::vector<double> moved = none, velocity = none;
  moved[3] = -0.25;  // vertex 1 moves down
  for (int node = 0; node < 4; ++node) velocity[2 * node] = 3.0, velocity[2 * node + 1] = -4.0;
  CellState state;
  state.von_mises = 1.0;
  state.pressure = 2.0;
  state.stored = 3.0;
  state.lost = 4.0;
  const std::vector<CellState> cells = {state};
  for (const double time : {0.0, 0.5})
    recorder.record({.time = time,
                     .displacement = time > 0.0 ? moved : none,
                     .velocity = velocity,
                     .contact_pressure = pressure,
                     .cells = cells,
                     .loss = Loss::dissipated});
  const ShapeHistory& history = recorder.history();
  EXPECT_EQ(history.time, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(history.positions[0], corners);
  EXPECT_EQ(history.positions[1][1], (std::array{1.0, -0.25}));
  EXPECT_EQ(history.positions[1][2], corners[2]);
  EXPECT_EQ(history.contact_pressure[1], (std::vector<float>{7.0f, 5.0f}));
  ASSERT_EQ(history.fields.size(), 5u);
  const std::pair<ShapeQuantity, float> expected[] = {{ShapeQuantity::von_mises, 1.0f},
                                                      {ShapeQuantity::pressure, 2.0f},
                                                      {ShapeQuantity::stored, 3.0f},
                                                      {ShapeQuantity::dissipated, 4.0f},
                                                      {ShapeQuantity::speed, 5.0f}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(history.fields[i].quantity, expected[i].first);
    EXPECT_EQ(history.fields[i].values, (std::vector<std::vector<float>>(2, {expected[i].second})));
  }
}

TEST(ShapeRecorder, AnElasticBodyShowsNoLoss) {
  ShapeRecorder recorder(one_cell(), corners);
  const std::vector<double> none(8, 0.0);
  const std::vector<CellState> cells(1);
  recorder.record({.displacement = none,
                   .velocity = none,
                   .contact_pressure = none,
                   .cells = cells,
                   .loss = Loss::none});
  for (const ShapeField& field : recorder.history().fields)
    EXPECT_NE(field.quantity, ShapeQuantity::dissipated);
}

}  // namespace
}  // namespace rebound::fem
