#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fem/implicit/body_forces.hpp"
#include "lumped/problem/adhesive_traction.hpp"

namespace rebound::fem {

/// Adhesive traction (AdhesiveTraction) between the plate z = 0 and the quadratic
/// sides of the contact group, by three Gauss points a side.
///
///   f_i = Σ_q N_i T(g_q) A_q,   ∂f_i/∂z_j = Σ_q N_i N_j T′(g_q) A_q,   A = 2π R ds at rest
///
/// counted as internal forces are: what the body needs to be held against it.
/// Limit: f is the gradient of the potential -> test AdhesiveSidesTest
class AdhesiveSides {
 public:
  /// `pattern` of the matrices that `linearise` is given.
  AdhesiveSides(const QuadraticBody& body, const AdhesiveTraction& traction,
                const SystemMatrix& pattern);

  void add_forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const;
  void add_derivative(const Eigen::VectorXd& u, SystemMatrix& matrix) const;
  double pull(const Eigen::VectorXd& u) const;       ///< on the whole body, towards the plate [N]
  double potential(const Eigen::VectorXd& u) const;  ///< −Σ A_q w (1 − g_q/r)², ≤ 0 [J]
  double energy(const Eigen::VectorXd& u) const {    ///< potential against that at first touch [J]
    return potential(u) - potential_at_rest_;
  }

 private:
  struct Point {
    std::array<int, 3> unknown{};     ///< u_z of the side's nodes
    std::array<double, 3> shape{};
    std::array<int, 6> place{};       ///< in the matrix, lower triangle row by row
    double height = 0.0;              ///< at rest [m]
    double area = 0.0;                ///< [m²]
  };
  /// 1 − g/r, or 0 beyond the range.
  double fade(const Point& point, const Eigen::VectorXd& u) const;
  /// 1 where the traction falls with the gap, 0 where it is constant or gone.
  double falls(const Point& point, const Eigen::VectorXd& u) const;
  double gap(const Point& point, const Eigen::VectorXd& u) const;

  AdhesiveTraction traction_;
  std::vector<Point> points_;
  double potential_at_rest_ = 0.0;
};

}  // namespace rebound::fem
