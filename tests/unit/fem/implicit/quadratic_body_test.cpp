// The nine-node body: places of its nodes, geometry of the curved side, mass.
#include "fem/implicit/quadratic_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/refine/refined_mesh.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

double volume_of(const QuadraticBody& body) {
  return body.mass / body.density;
}

// Σ N = 1, Σ N x = x, Σ x ∇N = 1 in every cell, curved sides and all: places, numbers
// of nodes and what deal.II says of its shape functions belong together.
TEST(QuadraticBodyTest, ShapesCarryOneAndThePlace) {
  const auto body = quadratic_body(generate_sphere_mesh({.radius = 1.0, .cells = 60}),
                                   {.radius = 1.0, .mass = 1.0});
  for (const QuadraticCell& cell : body.cells) {
    for (int side = 0; side < 4; ++side) {  // nodes in the order around the cell
      const auto &a = body.position[cell.nodes[side]],
                 &b = body.position[cell.nodes[(side + 1) % 4]];
      const auto& middle = body.position[cell.nodes[4 + side]];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      EXPECT_LT(std::hypot(0.5 * (a[0] + b[0]) - middle[0], 0.5 * (a[1] + b[1]) - middle[1]),
                0.1 * length);
    }
    for (const auto& point : cell.points) {
      double sum = 0.0, radius = 0.0, slope[2][2] = {};
      for (int i = 0; i < quadratic_nodes; ++i) {
        const auto& x = body.position[cell.nodes[i]];
        sum += point.shape[i];
        radius += point.shape[i] * x[0];
        for (int k = 0; k < 2; ++k)
          for (int s = 0; s < 2; ++s) slope[k][s] += x[k] * point.gradient[i][s];
      }
      EXPECT_NEAR(sum, 1.0, 1e-14);
      EXPECT_NEAR(radius, point.radius, 1e-14);
      for (int k = 0; k < 2; ++k)
        for (int s = 0; s < 2; ++s) EXPECT_NEAR(slope[k][s], k == s ? 1.0 : 0.0, 1e-12);
    }
  }
}

// Middle nodes of contact sides lie on the sphere; sides carry the sphere's area.
TEST(QuadraticBodyTest, ContactSidesFollowTheSphere) {
  const auto body = quadratic_body(generate_sphere_mesh({.radius = 1.0, .cells = 60}),
                                   {.radius = 1.0, .mass = 1.0});
  double area = 0.0;
  for (const ContactSide& side : body.contact_sides) {
    for (const int node : side.nodes)
      EXPECT_NEAR(std::hypot(body.position[node][0], body.position[node][1] - 1.0), 1.0, 1e-14);
    for (const auto& point : side.points) {
      double height = 0.0;
      for (int i = 0; i < 3; ++i) height += point.shape[i] * body.position[side.nodes[i]][1];
      EXPECT_NEAR(height, point.height, 1e-14);
      area += point.area;
    }
  }
  double top = 0.0;  // the contact group is a cap of area 2π R h
  for (const ContactPlace& place : body.contact) top = std::max(top, body.position[place.node][1]);
  EXPECT_NEAR(area / (2.0 * std::numbers::pi * top), 1.0, 1e-5);
}

TEST(QuadraticBodyTest, VolumeOfTheSphere) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi;
  Mesh mesh = generate_sphere_mesh({.radius = 1.0, .cells = 60});
  const auto miss = [&](double curved) {
    return std::abs(volume_of(quadratic_body(mesh, {.radius = curved, .mass = 1.0})) / sphere -
                    1.0);
  };
  const double coarse = miss(1.0), straight = miss(0.0);
  mesh = refined_mesh(mesh, 1.0);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log2(coarse / miss(1.0)), 3.7);
  EXPECT_NEAR(std::log2(straight / miss(0.0)), 2.0, 0.2);
}

TEST(QuadraticBodyTest, CylinderIsExact) {
  const Mesh mesh =
      test::cylinder({.radius = 0.5, .length = 2.0, .cells_across = 2, .cells_along = 3});
  const auto body = quadratic_body(mesh, {.mass = 3.0});
  EXPECT_NEAR(volume_of(body), std::numbers::pi * 0.25 * 2.0, 1e-14);
  EXPECT_EQ(body.cells.size(), 6u);
  EXPECT_EQ(body.node_count(), 5 * 7);
  EXPECT_EQ(body.axis_nodes.size(), 7u);
  ASSERT_EQ(body.contact.size(), 5u);
  for (const ContactPlace& place : body.contact) {
    // The nodes behind lie straight above, at half a cell and a whole one.
    const auto& at = body.position[place.node];
    EXPECT_EQ(at[1], 0.0);
    EXPECT_NEAR(body.position[place.behind[0]][1], 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(body.position[place.behind[1]][1], 2.0 / 3.0, 1e-15);
    for (const int behind : place.behind) EXPECT_NEAR(body.position[behind][0], at[0], 1e-15);
  }
}

TEST(QuadraticBodyTest, RefusesWhatIsNoBody) {
  const Mesh good = test::cylinder({.radius = 1.0, .length = 1.0});
  const auto refused = [](const Mesh& mesh) {
    return testing::refusal_of([&] { quadratic_body(mesh, {.mass = 1.0}); }).code();
  };
  Mesh empty = good, inverted = good, no_contact = good, no_axis = good, left = good;
  empty.cells.clear();
  std::swap(inverted.cells[0][1], inverted.cells[0][3]);
  no_contact.contact_edges.clear();
  no_axis.axis_edges.clear();
  left.vertices[0][0] = -0.1;
  for (const Mesh* mesh : {&empty, &inverted, &no_contact, &no_axis, &left})
    EXPECT_EQ(refused(*mesh), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound::fem
