#include "fem/element_tests/manufactured_solution.hpp"

#include <Eigen/Core>
#include <Eigen/SparseLU>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "fem/element_tests/bilinear_forces.hpp"
#include "fem/implicit/equilibrium.hpp"
#include "fem/materials/neo_hookean.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Vector2d>;  ///< derivatives in R and Z

const Material unit_material{.youngs_modulus = 2.8, .poisson_ratio = 0.4};

template <class T>
struct Exact {
  T r, z;         ///< displacement
  Gradient<T> f;  ///< deformation gradient
};

template <class T>
Exact<T> exact(const T& r, const T& z) {
  using std::cos;
  using std::sin;
  const T c = cos(z), s = sin(z);
  return {T(0.1 * r * c + 0.05 * r * r * r),
          T(0.1 * s * (1.0 - r * r)),
          {T(1.0 + 0.1 * c + 0.15 * r * r), T(-0.1 * r * s), T(-0.2 * r * s),
           T(1.0 + 0.1 * c * (1.0 - r * r)), T(1.0 + 0.1 * c + 0.05 * r * r)}};
}

template <class T>
Gradient<T> exact_stress(const T& r, const T& z) {
  const Gradient<T> f = exact(r, z).f;
  const NeoHookean law{
      Moduli::from_youngs(unit_material.youngs_modulus, unit_material.poisson_ratio)};
  const Strain<T> strain = strain_of(f, T(log(jacobian_of(f))));
  const Symmetric<T> d = law.deviatoric_stress(strain), v = law.volumetric_stress(strain);
  return first_piola<T>(f, {T(d.rr + v.rr), T(d.zz + v.zz), T(d.tt + v.tt), T(d.rz + v.rz)});
}

bool on_surface(const std::array<double, 2>& p) {
  return p[0] > 1.0 - 1e-9 || p[1] < 1e-9 || p[1] > 1.0 - 1e-9;
}

[[noreturn]] void not_converged() {
  throw Error(ExitCode::solver_failed,
              "Newton's method on the manufactured solution did not converge");
}

/// Integration points of either kind of cells, by one set of names.
struct Place {
  double r = 0.0, z = 0.0, weight = 0.0;
};

class ErrorSum {
 public:
  template <class Cell, class Shape, class Slope, class Displacement>
  void add(const Cell& cell, const Place& at, const Shape& shape, const Slope& slope,
           const Displacement& u) {
    double ur = 0.0, uz = 0.0;
    Gradient<double> f{1, 0, 0, 1, 1};
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
      const double r = u[2 * cell.nodes[i]], z = u[2 * cell.nodes[i] + 1];
      ur += shape[i] * r, uz += shape[i] * z;
      f.rr += slope[i][0] * r, f.rz += slope[i][1] * r;
      f.zr += slope[i][0] * z, f.zz += slope[i][1] * z;
    }
    f.tt += ur / at.r;
    const auto e = exact(at.r, at.z);
    const auto square = [](double x) { return x * x; };
    displacement_ += at.weight * (square(ur - e.r) + square(uz - e.z));
    gradient_ +=
        at.weight * (square(f.rr - e.f.rr) + square(f.rz - e.f.rz) + square(f.zr - e.f.zr) +
                     square(f.zz - e.f.zz) + square(f.tt - e.f.tt));
  }
  FieldError error() const { return {std::sqrt(displacement_), std::sqrt(gradient_)}; }

 private:
  double displacement_ = 0.0, gradient_ = 0.0;
};

template <class Cell, class Shape, class Load>
void add_load(const Cell& cell, const Place& at, const Shape& shape, Load& load) {
  const auto b = manufactured_body_force(at.r, at.z);
  for (std::size_t i = 0; i < cell.nodes.size(); ++i)
    for (int k = 0; k < 2; ++k) load[2 * cell.nodes[i] + k] += at.weight * shape[i] * b[k];
}

template <class Body, class Cell, class Shape>
double height(const Body& body, const Cell& cell, const Shape& shape) {
  double z = 0.0;
  for (std::size_t i = 0; i < cell.nodes.size(); ++i)
    z += shape[i] * body.position[cell.nodes[i]][1];
  return z;
}

FieldError nine_node_error(const Mesh& mesh) {
  const QuadraticBody body = quadratic_body(mesh, {.mass = 1.0});
  const BodyForces forces(body, unit_material, ContactInertia::kept);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(forces.size());
  const auto place = [&](const QuadraticCell& cell, const QuadraticCell::Point& point) {
    return Place{point.radius, height(body, cell, point.shape), point.weight};
  };
  for (const auto& cell : body.cells)
    for (const auto& point : cell.points) add_load(cell, place(cell, point), point.shape, load);
  EquilibriumTask task;
  task.linearise = [&](const Eigen::VectorXd& u, Eigen::VectorXd& residual, SystemMatrix& matrix) {
    const auto outcome = forces.linearise(u, 0.0, residual, matrix);
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
  ActiveSet held(body);
  if (!EquilibriumSearch(body, forces.mass()).solve(task, u, held, reaction).converged)
    not_converged();
  ErrorSum sum;
  for (const auto& cell : body.cells)
    for (const auto& point : cell.points)
      sum.add(cell, place(cell, point), point.shape, point.gradient, u);
  return sum.error();
}

/// The free unknowns of a bilinear body, and Newton's method on them.
class BilinearProblem {
 public:
  BilinearProblem(const Discretisation& body, const std::vector<double>& load)
      : forces_(body, unit_material, choose_cell_kernel()), load_(load), u_(forces_.size(), 0.0) {
    for (int node = 0; node < body.node_count(); ++node) {
      const auto& p = body.position[node];
      const auto e = exact(p[0], p[1]);  // on the surface given, inside a first guess
      u_[2 * node] = e.r;
      u_[2 * node + 1] = e.z;
      if (on_surface(p)) continue;
      if (p[0] > 0.0) free_.push_back(2 * node);
      free_.push_back(2 * node + 1);
    }
  }

  const std::vector<double>& solve() {
    for (int iteration = 0; iteration < 10; ++iteration) {
      const Eigen::VectorXd now = residual();
      if (now.norm() < 1e-11) return u_;
      Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(tangent(now));
      const Eigen::VectorXd change = solver.solve(now);
      for (Eigen::Index j = 0; j < count(); ++j) u_[free_[j]] -= change[j];
    }
    not_converged();
  }

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(free_.size()); }
  Eigen::VectorXd residual() {
    const auto& force = forces_.force(u_);
    Eigen::VectorXd result(count());
    for (Eigen::Index i = 0; i < count(); ++i) result[i] = force[free_[i]] - load_[free_[i]];
    return result;
  }
  Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& now) {
    constexpr double step = 1e-7;
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index j = 0; j < count(); ++j) {
      const double kept = u_[free_[j]];
      u_[free_[j]] = kept + step;
      const Eigen::VectorXd moved = residual();
      u_[free_[j]] = kept;
      for (Eigen::Index i = 0; i < count(); ++i)
        if (moved[i] != now[i]) entries.emplace_back(i, j, (moved[i] - now[i]) / step);
    }
    Eigen::SparseMatrix<double> matrix(count(), count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  BilinearForces forces_;
  const std::vector<double>& load_;
  std::vector<double> u_;
  std::vector<int> free_;
};

FieldError bilinear_error(const Mesh& mesh) {
  const Discretisation body = discretise(mesh, 1.0);
  std::vector<double> load(2 * (body.position.size() + 1), 0.0);
  const auto place = [&](const CellGeometry& cell, int q) {
    return Place{cell.radius[q], height(body, cell, cell.shape[q]), cell.weight[q]};
  };
  for (const auto& cell : body.cells)
    for (int q = 0; q < points_per_cell; ++q) add_load(cell, place(cell, q), cell.shape[q], load);
  BilinearProblem problem(body, load);
  const auto& u = problem.solve();
  ErrorSum sum;
  for (const auto& cell : body.cells)
    for (int q = 0; q < points_per_cell; ++q)
      sum.add(cell, place(cell, q), cell.shape[q], cell.gradient[q], u);
  return sum.error();
}

}  // namespace

std::array<double, 2> manufactured_body_force(double r, double z) {
  const Gradient<Dual> p = exact_stress(Dual(r, 2, 0), Dual(z, 2, 1));
  return {-(p.rr.derivatives()[0] + p.rz.derivatives()[1] + (p.rr.value() - p.tt.value()) / r),
          -(p.zr.derivatives()[0] + p.zz.derivatives()[1] + p.zr.value() / r)};
}

FieldError manufactured_error(const Mesh& mesh, CellKind cells) {
  return cells == CellKind::bilinear ? bilinear_error(mesh) : nine_node_error(mesh);
}

}  // namespace rebound::fem
