#include "fem/implicit/system_matrix.hpp"

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <set>

#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Constraints = dealii::AffineConstraints<double>;
using Vector = dealii::Vector<double>;

Vector copied(const Eigen::VectorXd& v) {
  return Vector(v.begin(), v.end());
}

Eigen::VectorXd copied(const Vector& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.begin(), v.size());
}

/// What stands for the velocity of contact nodes in the kinetic energy.
Constraints inertia_of(const QuadraticBody& body, ContactInertia inertia) {
  Constraints constraints;
  std::set<int> touching;
  for (const ContactPlace& place : body.contact) touching.insert(place.node);
  for (const auto& [node, behind] : body.contact) {
    if (inertia == ContactInertia::kept) break;
    if (touching.contains(behind[0]) || touching.contains(behind[1]))
      throw Error(ExitCode::bad_input, "mesh refused: the body behind the contact is one cell thin",
                  {.key = "model.mesh"});
    for (const int component : {0, 1}) {
      if (component == 0 && inertia != ContactInertia::removed_wholly) continue;
      constraints.add_line(2 * node + component);
      constraints.add_entry(2 * node + component, 2 * behind[0] + component, 2.0);
      constraints.add_entry(2 * node + component, 2 * behind[1] + component, -1.0);
    }
  }
  constraints.close();
  return constraints;
}

std::vector<unsigned> unknowns_of(const QuadraticCell& cell) {
  std::vector<unsigned> unknowns;
  for (const int node : cell.nodes)
    for (const int component : {0, 1}) unknowns.push_back(2 * node + component);
  return unknowns;
}

dealii::FullMatrix<double> cell_mass(const QuadraticCell& cell, double density) {
  dealii::FullMatrix<double> mass(2 * quadratic_nodes);
  for (int i = 0; i < quadratic_nodes; ++i)
    for (int j = 0; j < quadratic_nodes; ++j) {
      double m = 0.0;
      for (const auto& point : cell.points) m += point.weight * point.shape[i] * point.shape[j];
      for (const int component : {0, 1}) mass(2 * i + component, 2 * j + component) = density * m;
    }
  return mass;
}

}  // namespace

struct SystemMatrix::Parts {
  std::shared_ptr<const dealii::SparsityPattern> pattern;
  dealii::SparseMatrix<double> matrix;
};

SystemMatrix::SystemMatrix(const QuadraticBody& body, ContactInertia inertia)
    : parts_(std::make_unique<Parts>()) {
  const Constraints constraints = inertia_of(body, inertia);
  dealii::DynamicSparsityPattern couplings(2 * body.node_count());
  for (const auto& cell : body.cells)
    constraints.add_entries_local_to_global(unknowns_of(cell), couplings, true);
  const auto pattern = std::make_shared<dealii::SparsityPattern>();
  pattern->copy_from(couplings);
  parts_->pattern = pattern;
  parts_->matrix.reinit(*pattern);
  for (const auto& cell : body.cells)
    constraints.distribute_local_to_global(cell_mass(cell, body.density), unknowns_of(cell),
                                           parts_->matrix);
  for (const auto& line : constraints.get_lines())  // deal.II gives them a diagonal
    parts_->matrix.set(line.index, line.index, 0.0);
}

SystemMatrix::SystemMatrix(const SystemMatrix& other) : parts_(std::make_unique<Parts>()) {
  parts_->pattern = other.parts_->pattern;
  parts_->matrix.reinit(*parts_->pattern);
  set(1.0, other);
}

SystemMatrix::~SystemMatrix() = default;

void SystemMatrix::set(double factor, const SystemMatrix& other) {
  parts_->matrix.copy_from(other.parts_->matrix);
  parts_->matrix *= factor;
}

void SystemMatrix::add(std::span<const int> unknowns, std::span<const double> block) {
  static const Constraints none = [] {
    Constraints constraints;
    constraints.close();
    return constraints;
  }();
  const auto count = unknowns.size();
  none.distribute_local_to_global(dealii::FullMatrix<double>(count, count, block.data()),
                                  {unknowns.begin(), unknowns.end()}, parts_->matrix);
}

void SystemMatrix::add_row(int to, double factor, int from) {
  auto& matrix = parts_->matrix;
  for (auto entry = matrix.begin(from); entry != matrix.end(from); ++entry)
    matrix.add(to, entry->column(), factor * entry->value());
}

Eigen::VectorXd SystemMatrix::times(const Eigen::VectorXd& v) const {
  Vector product(parts_->matrix.m());
  parts_->matrix.vmult(product, copied(v));
  return copied(product);
}

std::vector<std::tuple<int, int, double>> SystemMatrix::entries() const {
  std::vector<std::tuple<int, int, double>> entries;
  for (const auto& entry : parts_->matrix)
    entries.emplace_back(entry.row(), entry.column(), entry.value());
  return entries;
}

struct ConstrainedSolver::Parts {
  Constraints constraints;
  dealii::SparseDirectUMFPACK factors;
};

ConstrainedSolver::ConstrainedSolver() : parts_(std::make_unique<Parts>()) {}
ConstrainedSolver::~ConstrainedSolver() = default;

bool ConstrainedSolver::factorise(SystemMatrix& matrix, const Given& given,
                                  Eigen::VectorXd& right) {
  Constraints& constraints = parts_->constraints;
  constraints.clear();
  for (const auto& [unknown, value] : given) {
    constraints.add_line(unknown);
    constraints.set_inhomogeneity(unknown, value);
  }
  constraints.close();
  Vector condensed = copied(right);
  constraints.condense(matrix.parts_->matrix, condensed);
  right = copied(condensed);
  try {
    parts_->factors.factorize(matrix.parts_->matrix);
  } catch (const dealii::ExceptionBase&) {
    return false;
  }
  return true;
}

Eigen::VectorXd ConstrainedSolver::solve(const Eigen::VectorXd& right) const {
  Vector x = copied(right);
  parts_->factors.solve(x);
  parts_->constraints.distribute(x);
  return copied(x);
}

Eigen::VectorXd ConstrainedSolver::respond(const Eigen::VectorXd& load) const {
  Vector x = copied(load);
  parts_->constraints.set_zero(x);
  parts_->factors.solve(x);
  return copied(x);
}

}  // namespace rebound::fem
