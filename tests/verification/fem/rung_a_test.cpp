// Rung a: a manufactured axisymmetric solution at finite strain, near-axis
// points included, on both kinds of cells.
//
//   u_r = 0.1 R cos Z + 0.05 R³,   u_z = 0.1 sin Z (1 − R²),   μ = 1 Pa, λ = 4 Pa
//   −Div P = B on a cylinder of radius 1 and height 1, u given on its surface
//
// Orders in L2/H1: bilinear cells 2/1, nine-node cells 3/2.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/AutoDiff>

#include "fem/implicit/equilibrium.hpp"
#include "fem/materials/neo_hookean.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Vector2d>;  ///< derivatives in R and Z

const Moduli unit_moduli = Moduli::from_youngs(2.8, 0.4);

template <class T>
struct Exact {
  T r, z;            ///< displacement
  Gradient<T> f;     ///< deformation gradient
};

template <class T>
Exact<T> exact(const T& r, const T& z) {
  using std::cos;
  using std::sin;
  const T c = cos(z), s = sin(z);
  return {T(0.1 * r * c + 0.05 * r * r * r), T(0.1 * s * (1.0 - r * r)),
          {T(1.0 + 0.1 * c + 0.15 * r * r), T(-0.1 * r * s), T(-0.2 * r * s),
           T(1.0 + 0.1 * c * (1.0 - r * r)), T(1.0 + 0.1 * c + 0.05 * r * r)}};
}

template <class T>
Gradient<T> exact_stress(const T& r, const T& z) {
  const Gradient<T> f = exact(r, z).f;
  const NeoHookean law{unit_moduli};
  const Strain<T> strain = strain_of(f, T(log(jacobian_of(f))));
  const Symmetric<T> d = law.deviatoric_stress(strain), v = law.volumetric_stress(strain);
  return first_piola<T>(f, {T(d.rr + v.rr), T(d.zz + v.zz), T(d.tt + v.tt), T(d.rz + v.rz)});
}

/// B = −Div P.
std::array<double, 2> body_force(double r, double z) {
  const Gradient<Dual> p = exact_stress(Dual(r, 2, 0), Dual(z, 2, 1));
  return {-(p.rr.derivatives()[0] + p.rz.derivatives()[1] + (p.rr.value() - p.tt.value()) / r),
          -(p.zr.derivatives()[0] + p.zz.derivatives()[1] + p.zr.value() / r)};
}

TEST(RungA, BodyForceOfTheManufacturedSolution) {
  struct Point {
    double r, z, b_r, b_z;
  };
  for (const Point& at : {Point{0.25, 0.25, -0.23257044097246, 0.35743610872518},
                          Point{0.5, 0.5, -0.45774960341445, 0.67223047766909},
                          Point{0.75, 0.1, -0.57601793108742, 0.12376196701162},
                          Point{0.9, -0.6, -0.71390910626763, -0.65936038015377},
                          Point{0.001, 0.3, -0.00095833792693215, 0.43622240623733}}) {
    const auto b = body_force(at.r, at.z);
    EXPECT_NEAR(b[0], at.b_r, 1e-12);
    EXPECT_NEAR(b[1], at.b_z, 1e-12);
  }
}

/// n × n cells, bent inside.
Mesh bent_cylinder(int n) {
  Mesh mesh = test::cylinder({.radius = 1.0, .length = 1.0, .cells_across = n, .cells_along = n});
  for (auto& [r, z] : mesh.vertices) {
    const double bend = 0.06 * std::sin(std::numbers::pi * r) * std::sin(std::numbers::pi * z);
    r += bend;
    z -= bend;
  }
  return mesh;
}

bool on_surface(const std::array<double, 2>& p) {
  return p[0] > 1.0 - 1e-9 || p[1] < 1e-9 || p[1] > 1.0 - 1e-9;
}

struct Errors {
  double l2 = 0.0, h1 = 0.0;
};

/// Adds one integration point with the displacement and gradient found there.
void add_error(Errors& sum, double r, double z, double weight, const std::array<double, 2>& u,
               const Gradient<double>& f) {
  const auto e = exact(r, z);
  const auto square = [](double x) { return x * x; };
  sum.l2 += weight * (square(u[0] - e.r) + square(u[1] - e.z));
  sum.h1 += weight * (square(f.rr - e.f.rr) + square(f.rz - e.f.rz) + square(f.zr - e.f.zr) +
                      square(f.zz - e.f.zz) + square(f.tt - e.f.tt));
}

Errors quadratic_errors(int n) {
  const auto body = quadratic_body(bent_cylinder(n), {.mass = 1.0});
  const BodyForces forces(body, test::unit_material(), ContactInertia::kept);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(forces.size());
  const auto place = [&](const QuadraticCell& cell, const QuadraticCell::Point& point) {
    double z = 0.0;
    for (int i = 0; i < quadratic_nodes; ++i) z += point.shape[i] * body.position[cell.nodes[i]][1];
    return std::array{point.radius, z};
  };
  for (const auto& cell : body.cells)
    for (const auto& point : cell.points) {
      const auto [r, z] = place(cell, point);
      const auto b = body_force(r, z);
      for (int i = 0; i < quadratic_nodes; ++i)
        for (int k = 0; k < 2; ++k)
          load[2 * cell.nodes[i] + k] += point.weight * point.shape[i] * b[k];
    }
  EquilibriumTask task;
  task.linearise = [&](const Eigen::VectorXd& u, Eigen::VectorXd& residual, SystemMatrix& matrix) {
    const auto outcome = forces.linearise(u, {}, residual, matrix);
    residual -= load;
    return outcome;
  };
  task.force_scale = load.norm();
  for (int node = 0; node < body.node_count(); ++node) {
    const auto& p = body.position[node];
    if (!on_surface(p)) continue;
    const auto e = exact(p[0], p[1]);
    task.prescribed.emplace_back(2 * node, e.r);
    task.prescribed.emplace_back(2 * node + 1, e.z);
  }
  Eigen::VectorXd u = Eigen::VectorXd::Zero(forces.size()), reaction;
  HeldNodes held(body);
  EXPECT_TRUE(EquilibriumSearch(body, forces.empty_matrix()).solve(task, u, held, reaction).converged);
  Errors errors;
  for (const auto& cell : body.cells)
    for (const auto& point : cell.points) {
      std::array<double, 2> at{};
      Gradient<double> f{1, 0, 0, 1, 1};
      for (int i = 0; i < quadratic_nodes; ++i) {
        const double ur = u[2 * cell.nodes[i]], uz = u[2 * cell.nodes[i] + 1];
        const auto& g = point.gradient[i];
        at[0] += point.shape[i] * ur;
        at[1] += point.shape[i] * uz;
        f.rr += g[0] * ur, f.rz += g[1] * ur, f.zr += g[0] * uz, f.zz += g[1] * uz;
      }
      f.tt += at[0] / point.radius;
      const auto [r, z] = place(cell, point);
      add_error(errors, r, z, point.weight, at, f);
    }
  return {std::sqrt(errors.l2), std::sqrt(errors.h1)};
}

/// The explicit kernel has no tangent: Newton's method with one of differences.
Errors bilinear_errors(int n) {
  const auto body = discretise(bent_cylinder(n), 1.0);
  test::KernelCase kernel(body, test::unit_material(), choose_cell_kernel());
  std::vector<double> load(kernel.size(), 0.0), u(kernel.size(), 0.0);
  std::vector<int> free;
  const auto height = [&](const CellGeometry& cell, int q) {
    double z = 0.0;
    for (int i = 0; i < nodes_per_cell; ++i) z += cell.shape[q][i] * body.position[cell.nodes[i]][1];
    return z;
  };
  for (const auto& cell : body.cells)
    for (int q = 0; q < points_per_cell; ++q) {
      const auto b = body_force(cell.radius[q], height(cell, q));
      for (int i = 0; i < nodes_per_cell; ++i)
        for (int k = 0; k < 2; ++k)
          load[2 * cell.nodes[i] + k] += cell.weight[q] * cell.shape[q][i] * b[k];
    }
  for (int node = 0; node < body.node_count(); ++node) {
    const auto& p = body.position[node];
    if (on_surface(p)) {
      const auto e = exact(p[0], p[1]);
      u[2 * node] = e.r;
      u[2 * node + 1] = e.z;
    } else {
      if (p[0] > 0.0) free.push_back(2 * node);
      free.push_back(2 * node + 1);
    }
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  const auto residual = [&] {
    const auto& force = kernel.force(u);
    Eigen::VectorXd result(count);
    for (Eigen::Index i = 0; i < count; ++i) result[i] = force[free[i]] - load[free[i]];
    return result;
  };
  Eigen::MatrixXd tangent(count, count);
  for (int iteration = 0; iteration < 8; ++iteration) {
    const Eigen::VectorXd now = residual();
    if (now.norm() < 1e-11) break;
    for (Eigen::Index j = 0; j < count; ++j) {
      constexpr double step = 1e-7;
      u[free[j]] += step;
      tangent.col(j) = (residual() - now) / step;
      u[free[j]] -= step;
    }
    const Eigen::VectorXd change = tangent.partialPivLu().solve(now);
    for (Eigen::Index j = 0; j < count; ++j) u[free[j]] -= change[j];
  }
  EXPECT_LT(residual().norm(), 1e-10);
  Errors errors;
  for (const auto& cell : body.cells)
    for (int q = 0; q < points_per_cell; ++q) {
      std::array<double, 2> at{};
      Gradient<double> f{1, 0, 0, 1, 1};
      for (int i = 0; i < nodes_per_cell; ++i) {
        const double ur = u[2 * cell.nodes[i]], uz = u[2 * cell.nodes[i] + 1];
        const auto& g = cell.gradient[q][i];
        at[0] += cell.shape[q][i] * ur;
        at[1] += cell.shape[q][i] * uz;
        f.rr += g[0] * ur, f.rz += g[1] * ur, f.zr += g[0] * uz, f.zz += g[1] * uz;
      }
      f.tt += at[0] / cell.radius[q];
      add_error(errors, cell.radius[q], height(cell, q), cell.weight[q], at, f);
    }
  return {std::sqrt(errors.l2), std::sqrt(errors.h1)};
}

void expect_orders(const Errors& coarse, const Errors& fine, double l2, double h1) {
  const double found_l2 = std::log2(coarse.l2 / fine.l2), found_h1 = std::log2(coarse.h1 / fine.h1);
  EXPECT_NEAR(found_l2, l2, 0.15) << coarse.l2 << " " << fine.l2;
  EXPECT_NEAR(found_h1, h1, 0.15) << coarse.h1 << " " << fine.h1;
  ::testing::Test::RecordProperty("order_l2", std::to_string(found_l2));
  ::testing::Test::RecordProperty("order_h1", std::to_string(found_h1));
}

TEST(RungA, BilinearCellsConvergeInSecondAndFirstOrder) {
  expect_orders(bilinear_errors(8), bilinear_errors(16), 2.0, 1.0);
}

TEST(RungA, NineNodeCellsConvergeInThirdAndSecondOrder) {
  expect_orders(quadratic_errors(8), quadratic_errors(16), 3.0, 2.0);
}

}  // namespace
}  // namespace rebound::fem
