// Forces, tangent and mass of the nine-node body.
#include "fem/implicit/body_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

using test::Random;

const QuadraticBody& distorted() {
  static const QuadraticBody body = quadratic_body(test::distorted_cylinder(), {.mass = 2.5});
  return body;
}

Eigen::VectorXd random_field(const QuadraticBody& body, double size, unsigned seed) {
  Random random(seed);
  Eigen::VectorXd u(2 * body.node_count());
  for (double& value : u) value = size * random();
  for (const int node : body.axis_nodes) u[2 * node] = 0.0;
  return u;
}

TEST(BodyForcesTest, ForceIsTheGradientOfTheEnergy) {
  for (const auto model : test::elastic_models) {
    const BodyForces forces(distorted(), test::unit_material(model), ContactInertia::kept);
    const auto u = random_field(distorted(), 0.02, 3),
               direction = random_field(distorted(), 1.0, 4);
    Eigen::VectorXd f;
    ASSERT_EQ(forces.forces(u, f), BodyForces::Outcome::done);
    const double energy = forces.stored_energy(u);
    const auto remainder = [&](double h) {
      return forces.stored_energy(u + h * direction) - energy - h * f.dot(direction);
    };
    EXPECT_NEAR(test::smallest_slope(remainder, 2e-3), 2.0, 0.1);
  }
}

TEST(BodyForcesTest, TangentIsTheDerivativeOfTheForce) {
  Material material = test::unit_material();
  material.branches = {{0.3, 0.4, Relaxes::all}};
  BodyForces forces(distorted(), material, ContactInertia::kept);
  forces.law().set_step(0.2);
  forces.accept(random_field(distorted(), 0.02, 5));
  const auto u = random_field(distorted(), 0.02, 3), direction = random_field(distorted(), 1.0, 4);
  Eigen::VectorXd f, moved;
  SystemMatrix k = forces.mass();
  ASSERT_EQ(forces.linearise(u, 0.0, f, k), BodyForces::Outcome::done);
  const Eigen::VectorXd change = k.times(direction);
  const auto remainder = [&](double h) {
    EXPECT_EQ(forces.forces(u + h * direction, moved), BodyForces::Outcome::done);
    return (moved - f - h * change).norm();
  };
  EXPECT_NEAR(test::smallest_slope(remainder, 2e-3), 2.0, 0.1);
}

TEST(BodyForcesTest, InsideOutIsSaid) {
  const BodyForces forces(distorted(), test::unit_material(), ContactInertia::kept);
  const auto u = random_field(distorted(), 2.0, 3);
  Eigen::VectorXd f;
  SystemMatrix k = forces.mass();
  EXPECT_EQ(forces.forces(u, f), BodyForces::Outcome::inverted);
  EXPECT_EQ(forces.linearise(u, 0.0, f, k), BodyForces::Outcome::inverted);
}

// Case a, patch test: a homogeneous deformation has no force inside, and the
// stresses and energy of the closed form (μ = 1 Pa, λ = 4 Pa).
TEST(BodyForcesTest, PatchTest) {
  struct Patch {
    double a, b, energy;
  };
  for (const Patch& patch :
       {Patch{1.1, 0.9, 0.0442786380302141}, Patch{0.8, 1.3, 0.2365780589552706},
        Patch{0.5, 0.5, 9.602595792207462}, Patch{1.5, 0.6, 0.810020940369229}}) {
    const QuadraticBody& body = distorted();
    const BodyForces forces(body, test::unit_material(), ContactInertia::kept);
    Eigen::VectorXd u(forces.size()), f;
    for (int node = 0; node < body.node_count(); ++node) {
      u[2 * node] = (patch.a - 1.0) * body.position[node][0];
      u[2 * node + 1] = (patch.b - 1.0) * body.position[node][1];
    }
    ASSERT_EQ(forces.forces(u, f), BodyForces::Outcome::done);
    EXPECT_NEAR(forces.stored_energy(u) / (body.mass / body.density) / patch.energy, 1.0, 1e-12);
    for (int node = 0; node < body.node_count(); ++node) {
      const auto& [r, z] = body.position[node];
      if (r > 0.999 || z < 1e-3 || z > 1.199) continue;  // of the surface
      EXPECT_NEAR(f[2 * node + 1], 0.0, 1e-12 * f.norm());
      if (r == 0.0) continue;  // held on the axis
      EXPECT_NEAR(f[2 * node], 0.0, 1e-12 * f.norm());
    }
  }
}

TEST(BodyForcesTest, MassIsTheMassAskedForWithAndWithoutInertiaAtTheContact) {
  const Mesh mesh = generate_sphere_mesh({.radius = 0.0331, .cells = 100});
  const auto body = quadratic_body(mesh, {.radius = 0.0331, .mass = 0.0896});
  for (const auto inertia : {ContactInertia::kept, ContactInertia::removed}) {
    const BodyForces forces(body, test::unit_material(), inertia);
    EXPECT_NEAR(forces.axial_mass().sum() / 0.0896, 1.0, 1e-13);
    // v = (r, c + z): kinetic energy of the sphere about z = R is exact.
    Eigen::VectorXd v(forces.size());
    for (int node = 0; node < body.node_count(); ++node) {
      v[2 * node] = 0.0;
      v[2 * node + 1] = body.position[node][1] - 0.0331;
    }
    const double kinetic = 0.5 * v.dot(forces.mass().times(v));
    EXPECT_NEAR(kinetic / (0.5 * 0.0896 * 0.0331 * 0.0331 / 5.0), 1.0, 2e-3);
  }
  const BodyForces removed(body, test::unit_material(), ContactInertia::removed);
  for (const ContactPlace& place : body.contact)
    EXPECT_EQ(removed.axial_mass()[2 * place.node + 1], 0.0);
}

// Where both nodes behind a contact node may touch as well, nothing can carry its inertia.
TEST(BodyForcesTest, RefusesABodyTooThinToCarryTheInertiaOfItsContact) {
  Mesh mesh = test::cylinder({.radius = 0.5, .length = 0.2, .cells_across = 2, .cells_along = 1});
  const auto make = [&] {
    const auto body = quadratic_body(mesh, {.mass = 1.0});
    BodyForces(body, test::unit_material(), ContactInertia::removed);
  };
  EXPECT_NO_THROW(make());
  for (const auto& cell : mesh.cells)
    for (int i = 0; i < 4; ++i)
      if (mesh.vertices[cell[i]][1] > 0.1 && mesh.vertices[cell[(i + 1) % 4]][1] > 0.1)
        mesh.contact_edges.push_back({cell[i], cell[(i + 1) % 4]});
  EXPECT_EQ(testing::refusal_of(make).code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound::fem
