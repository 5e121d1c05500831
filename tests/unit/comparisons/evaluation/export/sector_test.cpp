#include "comparisons/evaluation/export/sector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331;

QuadraticSection section_of(int cells) {
  return quadratic_section(generate_sphere_mesh({.radius = radius, .cells = cells}), radius);
}

/// Σ over faces of a closed body of ∫ x·n/3 would need curved faces; six tetrahedra of the
/// corners are near enough to tell a brick that is turned inside out.
double corner_volume(const Sector& sector, const std::array<int, 20>& brick) {
  const auto at = [&](int i) { return sector.nodes[brick[i]]; };
  const auto six_fold = [&](int a, int b, int c, int d) {
    const auto p = at(a), q = at(b), r = at(c), s = at(d);
    double e[3][3];
    for (int k = 0; k < 3; ++k) {
      e[0][k] = q[k] - p[k];
      e[1][k] = r[k] - p[k];
      e[2][k] = s[k] - p[k];
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  };
  double sum = 0.0;
  constexpr int cut[6][4] = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                             {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  for (const auto& c : cut) sum += six_fold(c[0], c[1], c[2], c[3]) / 6.0;
  return sum;
}

TEST(SectorTest, VolumeOfTheSphere) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
  EXPECT_NEAR(section_of(250).volume / sphere, 1.0, 1e-5);
  EXPECT_NEAR(section_of(1000).volume / sphere, 1.0, 1e-6);
  // The corners of a wedge span the polygon between them: a little less.
  constexpr double angle = 0.02;
  const Sector wedge = sector_of(section_of(1000), {.from = 0.0, .to = angle});
  double corners = 0.0;
  for (const auto& brick : wedge.bricks) {
    const double volume = corner_volume(wedge, brick);
    EXPECT_GT(volume, 0.0);
    corners += volume;
  }
  EXPECT_NEAR(corners / (sphere * angle / (2.0 * std::numbers::pi)), 1.0, 5e-3);
}

TEST(SectorTest, NodesOfAnEulerGrid) {
  const Mesh mesh = generate_sphere_mesh({.radius = radius, .cells = 250});
  const QuadraticSection section = quadratic_section(mesh, radius);
  // A disc: vertices − sides + cells = 1, and a node more on each side.
  const auto sides = section.nodes.size() - mesh.vertices.size();
  EXPECT_EQ(mesh.vertices.size() + mesh.cells.size(), sides + 1);
  EXPECT_EQ(section.contact_sides.size(), mesh.contact_edges.size());
  const Sector quarter =
      sector_of(section, {.from = 0.0, .to = 0.5 * std::numbers::pi, .slices = 4});
  EXPECT_EQ(quarter.bricks.size(), 4 * mesh.cells.size());
  EXPECT_EQ(quarter.contact_faces.size(), 4 * mesh.contact_edges.size());
  EXPECT_EQ(quarter.axis.size(), 2 * mesh.axis_edges.size() + 1);
  EXPECT_EQ(quarter.first_plane.size() + quarter.axis.size(), section.nodes.size());
  for (const int node : quarter.first_plane) EXPECT_EQ(quarter.nodes[node][1], 0.0);
  for (const int node : quarter.last_plane) EXPECT_NEAR(quarter.nodes[node][0], 0.0, 1e-17);
}

// Contact faces lie on the sphere, mid-side nodes too.
TEST(SectorTest, ContactFacesFollowTheSphere) {
  const QuadraticSection section = section_of(250);
  const Sector wedge = sector_of(section, {.from = -0.01, .to = 0.01});
  for (const auto& [brick, side] : wedge.contact_faces)
    for (const int local : {side, (side + 1) % 4, 4 + side, 8 + side, 12 + side, 16 + side}) {
      const auto& p = wedge.nodes[wedge.bricks[brick][local]];
      EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]), p[2] - radius), radius, 1e-9);
    }
}

// What a code reads for itself: every mid-side node is where its side is.
TEST(SectorTest, MidSidesBelongToTheirSides) {
  const Sector wedge = sector_of(section_of(250), {.from = -0.01, .to = 0.01});
  constexpr int sides[12][3] = {{0, 1, 8},  {1, 2, 9},  {2, 3, 10}, {3, 0, 11},
                                {4, 5, 12}, {5, 6, 13}, {6, 7, 14}, {7, 4, 15},
                                {0, 4, 16}, {1, 5, 17}, {2, 6, 18}, {3, 7, 19}};
  for (const auto& brick : wedge.bricks)
    for (const auto& [from, to, middle] : sides)
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(wedge.nodes[brick[middle]][k],
                    0.5 * (wedge.nodes[brick[from]][k] + wedge.nodes[brick[to]][k]), 0.01 * radius);
}

}  // namespace
}  // namespace rebound
