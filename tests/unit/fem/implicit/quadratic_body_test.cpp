// The nine-node body: shape functions, geometry of the curved side, mass.
#include "fem/implicit/quadratic_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/refine/refined_mesh.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

double volume_of(const QuadraticBody& body) { return body.mass / body.density; }

TEST(QuadraticBodyTest, ShapesAreOneAtTheirNodeAndSumToOne) {
  constexpr double nodes[quadratic_nodes][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1},
                                                {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
  for (int node = 0; node < quadratic_nodes; ++node) {
    const QuadraticShapes shapes(nodes[node][0], nodes[node][1]);
    for (int i = 0; i < quadratic_nodes; ++i) EXPECT_EQ(shapes.value[i], i == node ? 1.0 : 0.0);
  }
  constexpr double h = 1e-6;
  const QuadraticShapes at(0.3, -0.7), right(0.3 + h, -0.7), up(0.3, -0.7 + h);
  double sum = 0.0;
  for (int i = 0; i < quadratic_nodes; ++i) {
    sum += at.value[i];
    EXPECT_NEAR((right.value[i] - at.value[i]) / h, at.slope[i][0], 2e-6);
    EXPECT_NEAR((up.value[i] - at.value[i]) / h, at.slope[i][1], 2e-6);
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
}

TEST(QuadraticBodyTest, VolumeOfTheSphere) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi;
  Mesh mesh = generate_sphere_mesh({.radius = 1.0, .cells = 60});
  const auto miss = [&](double curved) {
    return std::abs(volume_of(quadratic_body(mesh, {.radius = curved, .mass = 1.0})) / sphere - 1.0);
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
