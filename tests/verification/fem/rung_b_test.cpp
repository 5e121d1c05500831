// Rung b: free vibration of the sphere, from stiffness and mass of the
// nine-node cells.
//
// Target: Lamb's frequency equations at ν = 0.4, R = 33.1 mm, m = 89.6 g,
// E = 10 MPa: spheroidal l = 2, 1, 3 and the radial mode.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "fem/implicit/body_forces.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

struct Spectrum {
  std::vector<double> frequencies;  ///< ascending, without the rigid motion [Hz]
  double radial = 0.0;              ///< of the mode that is most like u_r = R, u_z = Z [Hz]
};

Spectrum spectrum(int cells, ContactInertia inertia) {
  const auto problem = test::common_case(1.0);
  const double radius = problem.sphere.radius();
  const auto body = quadratic_body(
      generate_sphere_mesh({.radius = radius, .cells = cells, .grading = 1.0}),
      {.radius = radius, .mass = problem.sphere.mass});
  const BodyForces forces(body, problem.material, inertia);
  Eigen::VectorXd rest = Eigen::VectorXd::Zero(forces.size()), force;
  SystemMatrix stiffness = forces.empty_matrix();
  EXPECT_EQ(forces.linearise(rest, {}, force, stiffness), BodyForces::Outcome::done);
  std::vector<int> kept;
  std::vector<char> on_axis(body.node_count(), 0);
  for (const int node : body.axis_nodes) on_axis[node] = 1;
  for (int node = 0; node < body.node_count(); ++node) {
    if (!on_axis[node]) kept.push_back(2 * node);
    kept.push_back(2 * node + 1);
  }
  const Eigen::MatrixXd k_all = Eigen::MatrixXd(stiffness).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd m_all = Eigen::MatrixXd(forces.mass()).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd k = k_all(kept, kept), m = m_all(kept, kept);
  // Unknowns without inertia: M x = (1/ω²) K x has K singular by the rigid motion
  // alone; shifted by the mass it is positive definite.
  const double shift = std::pow(2.0 * std::numbers::pi * 100.0, 2);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(m, k + shift * m);
  Spectrum result;
  Eigen::VectorXd breathing(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto& p = body.position[kept[i] / 2];
    breathing[static_cast<Eigen::Index>(i)] = kept[i] % 2 == 0 ? p[0] : p[1] - radius;
  }
  double most = 0.0;
  for (Eigen::Index i = k.rows() - 1; i >= 0 && result.frequencies.size() < 12; --i) {
    const double omega_squared = 1.0 / solver.eigenvalues()[i] - shift;
    const double hertz = std::sqrt(std::max(omega_squared, 0.0)) / (2.0 * std::numbers::pi);
    if (hertz < 1.0) continue;
    result.frequencies.push_back(hertz);
    const Eigen::VectorXd mode = solver.eigenvectors().col(i);
    const double like = std::abs(mode.dot(m * breathing)) / std::sqrt(mode.dot(m * mode));
    if (like > most) {
      most = like;
      result.radial = hertz;
    }
  }
  return result;
}

TEST(RungB, FrequenciesOfTheSphere) {
  const Spectrum found = spectrum(60, ContactInertia::kept);
  ASSERT_GE(found.frequencies.size(), 4u);
  EXPECT_NEAR(found.frequencies[0] / 994.092, 1.0, 1e-3);   // l = 2
  EXPECT_NEAR(found.frequencies[1] / 1390.630, 1.0, 1e-3);  // l = 1
  EXPECT_NEAR(found.frequencies[2] / 1486.524, 1.0, 1e-3);  // l = 3
  EXPECT_NEAR(found.radial / 2654.658, 1.0, 1e-3);
}

// Contact nodes without inertia move the frequencies by less and less.
TEST(RungB, InertiaTakenFromTheContactDoesNotMatter) {
  const double coarse = spectrum(30, ContactInertia::removed).frequencies[0] / 994.092 - 1.0;
  const double fine = spectrum(120, ContactInertia::removed).frequencies[0] / 994.092 - 1.0;
  EXPECT_LT(std::abs(fine), 3e-3);
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse));
}

}  // namespace
}  // namespace rebound::fem
