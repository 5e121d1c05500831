#include "fem/element_tests/free_vibration.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "fem/element_tests/linear_stiffness.hpp"
#include "fem/implicit/body_forces.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int reported = 10;  ///< frequencies
constexpr int carried = 24;   ///< vectors of the iteration

/// Stiffness and mass of the unknowns that are free, lower triangles.
struct Pencil {
  Matrix stiffness, mass;
  Eigen::VectorXd breathing;  ///< X − X_centre
};

/// Numbers the unknowns off the axis, and the axial ones on it.
template <class Body>
std::vector<int> free_numbers(const Body& body) {
  std::vector<int> number(2 * body.node_count(), 0);
  for (const int node : body.axis_nodes) number[2 * node] = -1;
  int next = 0;
  for (int& n : number)
    if (n == 0) n = next++;
  return number;
}

template <class Body>
Eigen::VectorXd breathing_of(const Body& body, const std::vector<int>& number, double radius) {
  Eigen::VectorXd motion(*std::max_element(number.begin(), number.end()) + 1);
  for (int i = 0; i < static_cast<int>(number.size()); ++i)
    if (number[i] >= 0)
      motion[number[i]] = i % 2 == 0 ? body.position[i / 2][0] : body.position[i / 2][1] - radius;
  return motion;
}

Matrix from_triplets(Eigen::Index size, const Triplets& entries) {
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Matrix free_part(const SystemMatrix& all, const std::vector<int>& number, Eigen::Index size) {
  Triplets entries;
  for (const auto& [row, column, value] : all.entries())
    if (number[row] >= number[column] && number[column] >= 0)
      entries.emplace_back(number[row], number[column], value);
  return from_triplets(size, entries);
}

Pencil nine_node_pencil(const Mesh& mesh, VibratingMass mass, const VibratingSphere& sphere) {
  const QuadraticBody body = quadratic_body(mesh, {.radius = sphere.radius, .mass = sphere.mass});
  const BodyForces forces(
      body, sphere.material,
      mass == VibratingMass::own ? ContactInertia::kept : ContactInertia::removed);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(forces.size());
  Eigen::VectorXd force;
  SystemMatrix stiffness = forces.mass();
  forces.linearise(rest, 0.0, force, stiffness);
  const auto number = free_numbers(body);
  Pencil pencil{
      .stiffness = {}, .mass = {}, .breathing = breathing_of(body, number, sphere.radius)};
  pencil.stiffness = free_part(stiffness, number, pencil.breathing.size());
  pencil.mass = free_part(forces.mass(), number, pencil.breathing.size());
  return pencil;
}

Pencil bilinear_pencil(const Mesh& mesh, const VibratingSphere& sphere) {
  const Discretisation body = discretise(mesh, sphere.mass);
  const auto number = free_numbers(body);
  Pencil pencil{
      .stiffness = {}, .mass = {}, .breathing = breathing_of(body, number, sphere.radius)};
  Triplets stiffness, mass;
  for (const auto& entry : bilinear_stiffness(body, sphere.material, 1e-6 * sphere.radius))
    if (number[entry.row()] >= number[entry.col()] && number[entry.col()] >= 0)
      stiffness.emplace_back(number[entry.row()], number[entry.col()], entry.value());
  for (int j = 0; j < static_cast<int>(number.size()); ++j)
    if (number[j] >= 0) mass.emplace_back(number[j], number[j], body.mass[j / 2]);
  pencil.stiffness = from_triplets(pencil.breathing.size(), stiffness);
  pencil.mass = from_triplets(pencil.breathing.size(), mass);
  return pencil;
}

/// ω² ascending and the modes, normalised by the mass.
struct Modes {
  Eigen::VectorXd omega_squared;
  Eigen::MatrixXd vectors;
};

Modes lowest_modes(const Pencil& pencil) {
  const double shift = std::pow(2.0 * std::numbers::pi * 100.0, 2);
  const Matrix shifted = pencil.stiffness + shift * pencil.mass;
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver(shifted);
  const auto mass = pencil.mass.selfadjointView<Eigen::Lower>();
  const auto stiffness = shifted.selfadjointView<Eigen::Lower>();
  const Eigen::Index size = pencil.breathing.size(), width = std::min<Eigen::Index>(carried, size);
  Eigen::MatrixXd x(size, width);
  unsigned state = 1;  // any start that no mode is orthogonal to, the same on every machine
  for (Eigen::Index j = 0; j < width; ++j)
    for (Eigen::Index i = 0; i < size; ++i) {
      state = 1664525u * state + 1013904223u;
      x(i, j) = static_cast<double>(state) / 4294967296.0 - 0.5;
    }
  Eigen::VectorXd before = Eigen::VectorXd::Zero(width);
  for (int iteration = 0; iteration < 300; ++iteration) {
    const Eigen::MatrixXd y = solver.solve(Eigen::MatrixXd(mass * x));
    const Eigen::MatrixXd k = y.transpose() * (stiffness * y), m = y.transpose() * (mass * y);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(k, m);
    x = y * small.eigenvectors();
    const Eigen::VectorXd& now = small.eigenvalues();
    const Eigen::Index watched = std::min<Eigen::Index>(reported + 1, width);
    const bool still =
        (now - before).head(watched).cwiseAbs().maxCoeff() < 1e-11 * now[watched - 1];
    before = now;
    if (still) return {now.array() - shift, x};
  }
  throw Error(ExitCode::solver_failed,
              "subspace iteration for the free vibration did not converge");
}

}  // namespace

FreeVibration free_vibration(const Mesh& mesh, CellKind cells, VibratingMass mass,
                             const VibratingSphere& sphere) {
  const Pencil pencil = cells == CellKind::bilinear ? bilinear_pencil(mesh, sphere)
                                                    : nine_node_pencil(mesh, mass, sphere);
  const Modes modes = lowest_modes(pencil);
  const Eigen::VectorXd weighed = pencil.mass.selfadjointView<Eigen::Lower>() * pencil.breathing;
  FreeVibration result;
  double most = 0.0;
  for (Eigen::Index i = 0; i < modes.omega_squared.size(); ++i) {
    const double hertz =
        std::sqrt(std::max(modes.omega_squared[i], 0.0)) / (2.0 * std::numbers::pi);
    if (hertz < 1.0) continue;  // the rigid motion
    if (result.frequencies.size() == reported) break;
    result.frequencies.push_back(hertz);
    const double like = std::abs(modes.vectors.col(i).dot(weighed));
    if (like > most) {
      most = like;
      result.radial = hertz;
    }
  }
  return result;
}

}  // namespace rebound::fem
