#include "meshes/quality/mesh_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/meshes.hpp"

namespace rebound {
namespace {

TEST(MeshQualityTest, VolumeOfCylinder) {
  Mesh mesh = test::cylinder({.radius = 0.3, .length = 0.7, .cells_across = 5, .cells_along = 4});
  const double volume = std::numbers::pi * 0.3 * 0.3 * 0.7;
  EXPECT_NEAR(measure_quality(mesh).volume / volume, 1.0, 1e-14);
  mesh.vertices[8] = {0.13, 0.2};  // an inner vertex changes no volume
  EXPECT_NEAR(measure_quality(mesh).volume / volume, 1.0, 1e-14);
}

TEST(MeshQualityTest, VolumeOfConeFrustum) {
  Mesh mesh;
  mesh.vertices = {{0, 0}, {2, 0}, {1, 3}, {0, 3}};
  mesh.cells = {{0, 1, 2, 3}};
  EXPECT_NEAR(measure_quality(mesh).volume, std::numbers::pi * 3.0 / 3.0 * (4.0 + 2.0 + 1.0),
              1e-13);
}

TEST(MeshQualityTest, EdgesAndCounts) {
  const MeshQuality quality = measure_quality(
      test::cylinder({.radius = 1, .length = 3, .cells_across = 4, .cells_along = 6}));
  EXPECT_EQ(quality.cells, 24);
  EXPECT_EQ(quality.vertices, 35);
  EXPECT_DOUBLE_EQ(quality.smallest_edge, 0.25);
  EXPECT_DOUBLE_EQ(quality.largest_edge, 0.5);
  EXPECT_DOUBLE_EQ(quality.contact_edge_length, 0.25);
  EXPECT_DOUBLE_EQ(quality.worst_scaled_jacobian, 1.0);
}

TEST(MeshQualityTest, ScaledJacobianIsTheSineOfTheWorstCorner) {
  Mesh mesh;
  mesh.vertices = {
      {0, 0}, {1, 0}, {1 + std::cos(1.0), std::sin(1.0)}, {std::cos(1.0), std::sin(1.0)}};
  mesh.cells = {{0, 1, 2, 3}};
  EXPECT_NEAR(measure_quality(mesh).worst_scaled_jacobian, std::sin(1.0), 1e-15);
  mesh.cells = {{0, 3, 2, 1}};
  EXPECT_NEAR(measure_quality(mesh).worst_scaled_jacobian, -std::sin(1.0), 1e-15);
}

}  // namespace
}  // namespace rebound
