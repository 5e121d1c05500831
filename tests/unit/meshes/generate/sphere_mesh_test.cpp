#include "meshes/generate/sphere_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "meshes/quality/check_mesh.hpp"
#include "meshes/quality/mesh_quality.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Follows edges from `start` and returns the end of the chain and its length.
std::pair<int, std::size_t> follow(const std::vector<std::array<int, 2>>& edges, int start) {
  std::multimap<int, int> next;
  for (const auto& [a, b] : edges) {
    next.emplace(a, b);
    next.emplace(b, a);
  }
  int before = -1, at = start;
  std::size_t steps = 0;
  for (;; ++steps) {
    const auto [low, high] = next.equal_range(at);
    const auto ahead = std::find_if(low, high, [&](const auto& e) { return e.second != before; });
    if (ahead == high || steps > edges.size()) return {at, steps};
    before = at;
    at = ahead->second;
  }
}

int vertex_at(const Mesh& mesh, double r, double z) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (std::hypot(mesh.vertices[i][0] - r, mesh.vertices[i][1] - z) < 1e-9 * radius)
      return static_cast<int>(i);
  return -1;
}

TEST(SphereMeshTest, CountQualityAndVolume) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  for (const int cells : {150, 500, 2000})
    for (const double grading : {1.0, 8.0}) {
      const Mesh mesh =
          generate_sphere_mesh({.radius = radius, .cells = cells, .grading = grading});
      const MeshQuality quality = measure_quality(mesh);
      EXPECT_NEAR(quality.cells, cells, 0.05 * cells) << cells << " grading " << grading;
      EXPECT_GT(quality.worst_scaled_jacobian, 0.3) << cells << " grading " << grading;
      // Chords lose (Δφ)²/5 or so of the volume: of the order of 1/cells.
      EXPECT_LT(quality.volume, sphere);
      EXPECT_GT(quality.volume, sphere * (1.0 - 4.0 * std::sqrt(grading) / cells))
          << cells << " grading " << grading;
      EXPECT_NO_THROW(check_mesh(mesh, "generated"));
    }
}

TEST(SphereMeshTest, VolumeConvergesToTheSphere) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  double before = 0.0;
  for (const int cells : {100, 400, 1600}) {
    const MeshQuality quality =
        measure_quality(generate_sphere_mesh({.radius = radius, .cells = cells, .grading = 1.0}));
    const double missing = 1.0 - quality.volume / sphere;
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / missing), 2.0, 0.3) << cells;
    }
    before = missing;
  }
}

TEST(SphereMeshTest, AnyGradingKeepsTheAngles) {
  for (const int cells : {150, 1000})
    for (const double grading : {1.0, 30.0, 200.0})
      EXPECT_GT(measure_quality(
                    generate_sphere_mesh({.radius = radius, .cells = cells, .grading = grading}))
                    .worst_scaled_jacobian,
                0.7)
          << cells << " grading " << grading;
}

TEST(SphereMeshTest, SmallestMeshesAreUsable) {
  // Below 150 cells a corner can be sharp, but none is turned over.
  for (const int cells : {20, 60, 100})
    EXPECT_GT(
        measure_quality(generate_sphere_mesh({.radius = radius, .cells = cells, .grading = 1.0}))
            .worst_scaled_jacobian,
        0.1)
        << cells;
}

TEST(SphereMeshTest, GroupsAreComplete) {
  for (const int cells : {200, 1000}) {
    const Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = cells});
    const int pole = vertex_at(mesh, 0, 0), top = vertex_at(mesh, 0, 2 * radius);
    ASSERT_GE(pole, 0);
    ASSERT_GE(top, 0);
    for (const auto* edges : {&mesh.axis_edges, &mesh.contact_edges}) {
      const auto [end, steps] = follow(*edges, pole);
      EXPECT_EQ(end, top);
      EXPECT_EQ(steps, edges->size());
    }
    for (const auto& edge : mesh.axis_edges)
      for (const int vertex : edge) EXPECT_EQ(mesh.vertices[vertex][0], 0.0);
    for (const auto& edge : mesh.contact_edges)
      for (const int vertex : edge) {
        const auto& [r, z] = mesh.vertices[vertex];
        EXPECT_NEAR(std::hypot(r, z - radius) / radius, 1.0, 1e-9);
      }
  }
}

TEST(SphereMeshTest, CellsAreGradedToTheContact) {
  const Mesh even = generate_sphere_mesh({.radius = radius, .cells = 1000, .grading = 1.0});
  const Mesh graded = generate_sphere_mesh({.radius = radius, .cells = 1000, .grading = 8.0});
  EXPECT_LT(measure_quality(graded).contact_edge_length,
            0.5 * measure_quality(even).contact_edge_length);
}

int vertices_within(const Mesh& mesh, double contact_radius) {
  std::set<int> inside;
  for (const auto& edge : mesh.contact_edges)
    for (const int vertex : edge)
      if (mesh.vertices[vertex][0] <= contact_radius) inside.insert(vertex);
  return static_cast<int>(inside.size());
}

TEST(SphereMeshTest, EightVerticesInTheContact) {
  for (const int cells : {250, 1000, 4000})
    for (const double contact : {0.06, 0.12, 0.3, 0.6}) {
      const double grading = grading_for_contact(cells, contact);
      const Mesh mesh =
          generate_sphere_mesh({.radius = radius, .cells = cells, .grading = grading});
      // Nine with the pole; the last may miss the radius by rounding.
      EXPECT_GE(vertices_within(mesh, contact * radius), 8) << cells << " " << contact;
      EXPECT_GE(grading, 1.5);
      EXPECT_LE(grading, 200.0);
    }
  EXPECT_EQ(grading_for_contact(250, 0.001), 200.0);
  for (const double none : {0.0, -1.0, 1.5, nan}) EXPECT_EQ(grading_for_contact(250, none), 1.5);
}

TEST(SphereMeshTest, AContactOfAThirdOfTheRadiusKeepsTheDefaultGrading) {
  for (const int cells : {1000, 4000}) EXPECT_EQ(grading_for_contact(cells, 0.345), 1.5);
}

TEST(SphereMeshTest, SameRequestSameMesh) {
  const SphereMeshRequest request{.radius = radius, .cells = 300};
  const Mesh a = generate_sphere_mesh(request), b = generate_sphere_mesh(request);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.cells, b.cells);
}

TEST(SphereMeshTest, RefusesRequestsOutOfRange) {
  const auto key_refused = [](const SphereMeshRequest& request) {
    const Error error = testing::refusal_of([&] { generate_sphere_mesh(request); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  };
  for (const double bad : {0.0, -1.0, nan, infinity})
    EXPECT_EQ(key_refused({.radius = bad}), "radius");
  for (const int bad : {-5, 0, 19})
    EXPECT_EQ(key_refused({.radius = radius, .cells = bad}), "cells");
  for (const double bad : {0.5, -4.0, 201.0, nan, infinity})
    EXPECT_EQ(key_refused({.radius = radius, .grading = bad}), "grading");
}

TEST(SphereMeshTest, LowerHalfEndsAtItsPlane) {
  for (const double grading : {1.0, 30.0})
    for (const int cells : {60, 1000}) {
      const Mesh mesh = generate_sphere_mesh(
          {.radius = 2.0, .cells = cells, .grading = grading, .part = SpherePart::lower_half});
      EXPECT_GT(measure_quality(mesh).worst_scaled_jacobian, 0.45) << grading << " " << cells;
      double highest = 0.0;
      int in_plane = 0;
      for (const auto& [r, z] : mesh.vertices) {
        highest = std::max(highest, z);
        in_plane += z == 2.0 ? 1 : 0;
      }
      EXPECT_EQ(highest, 2.0);
      EXPECT_GE(in_plane, 3);
      double reach = 0.0;
      for (const auto& edge : mesh.contact_edges)
        for (const int vertex : edge) {
          const auto& [r, z] = mesh.vertices[vertex];
          EXPECT_NEAR(std::hypot(r, z - 2.0), 2.0, 1e-12);
          reach = std::max(reach, r);
        }
      EXPECT_EQ(reach, 2.0);  // up to the corner
    }
}

TEST(SphereMeshTest, SizesFarFromOurs) {
  for (const double size : {1e-4, 50.0}) {
    const Mesh mesh = generate_sphere_mesh({.radius = size, .cells = 300});
    EXPECT_NO_THROW(check_mesh(mesh, "generated"));
    EXPECT_GT(measure_quality(mesh).worst_scaled_jacobian, 0.3);
  }
}

}  // namespace
}  // namespace rebound
