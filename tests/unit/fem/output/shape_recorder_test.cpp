#include "fem/output/shape_recorder.hpp"

#include <gtest/gtest.h>

namespace rebound::fem {
namespace {

Discretisation one_cell() {
  Discretisation body;
  body.position = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}, {0.0, 2.0}};
  body.cells.resize(1);
  body.cells[0].nodes = {0, 1, 2, 3};
  return body;
}

TEST(ShapeRecorder, KeepsNothingUnlessAsked) {
  const Discretisation body = one_cell();
  ShapeRecorder recorder(body, 0, 1.0);
  recorder.record_if_due(0.5, std::vector<double>(8, 0.1));
  EXPECT_TRUE(recorder.history().time.empty());
  EXPECT_TRUE(recorder.history().cells.empty());
}

TEST(ShapeRecorder, StartsAtRestAndAddsDisplacements) {
  const Discretisation body = one_cell();
  ShapeRecorder recorder(body, 4, 1.0);
  for (int step = 1; step <= 100; ++step) {
    const double time = 0.01 * step + 1e-12;
    std::vector<double> displacement(8, 0.0);
    displacement[3] = -time;  // vertex 1 moves down
    recorder.record_if_due(time, displacement);
  }
  const ShapeHistory& history = recorder.history();
  ASSERT_EQ(history.time.size(), 5u);
  EXPECT_EQ(history.positions[0], body.position);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(history.time[i], 0.25 * static_cast<double>(i), 1e-9);
    EXPECT_DOUBLE_EQ(history.positions[i][1][1], -history.time[i]);
    EXPECT_EQ(history.positions[i][2], body.position[2]);
  }
  EXPECT_EQ(history.cells, (std::vector<std::array<int, 4>>{{0, 1, 2, 3}}));
}

}  // namespace
}  // namespace rebound::fem
