#pragma once

#include <Eigen/Core>
#include <array>

#include "fem/implicit/quadratic_body.hpp"
#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

inline constexpr int quadratic_unknowns = 2 * quadratic_nodes;  ///< (u_r, u_z) by node
/// Strain increments (E_rr, E_zz, E_tt, 2 E_rz) of the unknowns of a cell.
using StrainRows = Eigen::Matrix<double, 4, quadratic_unknowns>;
using CellMatrix = Eigen::Matrix<double, quadratic_unknowns, quadratic_unknowns>;

/// Takes the volume ratios J of the points of a cell to ratios that vary linearly over it:
/// Θ = A J, the projection onto 1, R, Z with the weights of the volume at rest.
using DilatationProjection = Eigen::Matrix<double, quadratic_points, quadratic_points>;
DilatationProjection dilatation_projection(const QuadraticBody& body, const QuadraticCell& cell);

/// Motion of all points of a cell as the material sees it.
///
///   F̄ = α F,   α = (Θ/J)^(1/3);   cells that keep their own volume ratios have α = 1
///
/// Nine displacement nodes with a linear volume ratio and, its counterpart, a linear pressure
/// in each cell neither lock nor oscillate: the pair Q2/P1, both condensed out of the cell.
///
/// Valid:  J > 0 and Θ > 0 at all points, else `inverted`
/// Limit:  forces are the gradient of ∫ W(F̄) dV and the tangent their derivative
///         -> tests QuadraticMotionTest
/// Source: Simo, Taylor & Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177; the pair:
///         Boffi, Brezzi & Fortin, Mixed Finite Element Methods (2013), §8.6.
class QuadraticMotion {
 public:
  /// `projection`: null for cells that keep their own volume ratios.
  QuadraticMotion(const QuadraticCell& cell, const Eigen::VectorXd& u,
                  const DilatationProjection* projection);

  bool inverted() const { return inverted_; }
  Gradient<double> gradient(int q) const;             ///< F̄
  Symmetric<double> right_cauchy_green(int q) const;  ///< C̄

  /// ∂Ē/∂u of all points.
  std::array<StrainRows, quadratic_points> strain_rows() const;

  /// Σ w S̄ : ∂²Ē/∂u² of the cell is the sum of both: α² S̄ : ∂²E/∂u² of each point, with w S̄
  /// as (rr, zz, tt, rz), and what α adds in the whole cell.
  using Stresses = std::array<Eigen::Vector4d, quadratic_points>;
  void add_geometric_stiffness(int q, const Eigen::Vector4d& stress, CellMatrix& stiffness) const;
  void add_dilatation_stiffness(const Stresses& stress, CellMatrix& stiffness) const;

 private:
  using Row = Eigen::Matrix<double, quadratic_unknowns, 1>;
  struct Rates {
    std::array<Row, quadratic_points> own, shared;  ///< ∂ ln J/∂u, ∂ ln Θ/∂u
  };
  Rates rates() const;
  StrainRows own_rows(int q) const;  ///< ∂E/∂u
  void add_jacobian_curvature(int q, double weight, CellMatrix& stiffness) const;

  const QuadraticCell& cell_;
  const DilatationProjection* projection_;
  std::array<Gradient<double>, quadratic_points> gradient_;      ///< F
  Eigen::Matrix<double, quadratic_points, 1> jacobian_, ratio_;  ///< J, Θ
  std::array<double, quadratic_points> scale_;                   ///< α
  bool inverted_ = false;
};

}  // namespace rebound::fem
