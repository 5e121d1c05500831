#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/implicit/quadratic_body.hpp"

namespace rebound::fem {

/// Inertia of the nodes next to the plate.
enum class ContactInertia {
  kept,
  removed,        ///< contact nodes move in z without mass of their own; see SystemMatrix
  removed_wholly  ///< in r too, as nodes do that stick to the plate and let go
};

/// A symmetric matrix on the unknowns (u_r, u_z) of node after node, held by deal.II.
///
///   kinetic energy ½ vᵀ M v,   M_ij = ∫ ρ N_i N_j dV
///
/// With ContactInertia::removed the axial velocity (with removed_wholly the radial one as well) of
/// a contact node that M sees is the linear extension of the two nodes behind it, v = 2 v₁ − v₂, a
/// constraint under which M is assembled. The mass stays what it is, to the last
/// digit, and every linear velocity field keeps its kinetic energy; but a contact
/// node has no inertia of its own, so that it meets and leaves the plate without a blow.
///
/// Errors: Error(bad_input) where the body behind the contact is one cell thin.
/// Source: mass at the contact removed: Khenous, Laborde & Renard 2008.
class SystemMatrix {
 public:
  /// M, with room for whatever the unknowns of one cell give each other.
  SystemMatrix(const QuadraticBody& body, ContactInertia inertia);
  SystemMatrix(const SystemMatrix& other);
  ~SystemMatrix();

  /// factor · other, which must have the same origin.
  void set(double factor, const SystemMatrix& other);
  /// Adds a symmetric block, row after row.
  void add(std::span<const int> unknowns, std::span<const double> block);
  /// Adds factor · row `from` to row `to`: both are unknowns of one node.
  void add_row(int to, double factor, int from);

  Eigen::VectorXd times(const Eigen::VectorXd& v) const;
  std::vector<std::tuple<int, int, double>> entries() const;  ///< row, column, value

 private:
  friend class ConstrainedSolver;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Solves A x = b where some of x is given: deal.II's AffineConstraints and
/// SparseDirectUMFPACK. Constraints are condensed out of the assembled matrix, because
/// contact decides on them when the residual is known.
class ConstrainedSolver {
 public:
  using Given = std::vector<std::pair<int, double>>;  ///< unknown and its value

  ConstrainedSolver();
  ~ConstrainedSolver();

  /// Condenses `matrix` and the right side, then factorises; false where A is singular.
  bool factorise(SystemMatrix& matrix, const Given& given, Eigen::VectorXd& right);
  /// x for the condensed right side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// What `load` changes in x: nothing in what is given.
  Eigen::VectorXd respond(const Eigen::VectorXd& load) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rebound::fem
