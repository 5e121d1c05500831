#include "meshes/refine/refined_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"
#include "tests/support/meshes.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331;
constexpr double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;

TEST(RefinedMeshTest, NewVerticesOfTheSurfaceLieOnTheSphere) {
  const Mesh coarse = generate_sphere_mesh({.radius = radius, .cells = 60});
  const Mesh fine = refined_mesh(coarse, radius);
  EXPECT_EQ(fine.cells.size(), 4 * coarse.cells.size());
  EXPECT_EQ(fine.contact_edges.size(), 2 * coarse.contact_edges.size());
  EXPECT_EQ(fine.axis_edges.size(), 2 * coarse.axis_edges.size());
  for (const auto& edge : fine.contact_edges)
    for (const int vertex : edge) {
      const auto& [r, z] = fine.vertices[static_cast<std::size_t>(vertex)];
      EXPECT_NEAR(std::hypot(r, z - radius) / radius, 1.0, 1e-12);
    }
}

// Chords miss the volume of a sphere by the square of their length.
TEST(RefinedMeshTest, HalfTheEdgesMissAQuarterOfTheVolume) {
  Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = 60});
  for (int times = 0; times < 3; ++times) {
    const double before = 1.0 - measure_quality(mesh).volume / volume;
    mesh = refined_mesh(mesh, radius);
    EXPECT_NEAR((1.0 - measure_quality(mesh).volume / volume) / before, 0.25, 0.01);
  }
}

// Flat sides stay flat, wherever they are.
TEST(RefinedMeshTest, ACylinderKeepsItsVolume) {
  const Mesh mesh =
      test::cylinder({.radius = 0.3, .length = 0.7, .cells_across = 2, .cells_along = 3});
  EXPECT_NEAR(measure_quality(refined_mesh(mesh, 0.3)).volume / measure_quality(mesh).volume, 1.0,
              1e-14);
}

}  // namespace
}  // namespace rebound
