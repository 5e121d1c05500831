#include "fem/implicit/quadratic_motion.hpp"

#include <Eigen/LU>
#include <cmath>

namespace rebound::fem {
namespace {

Gradient<double> gradient_at(const QuadraticCell& cell, const QuadraticCell::Point& point,
                             const Eigen::VectorXd& u) {
  Gradient<double> f{1.0, 0.0, 0.0, 1.0, 0.0};
  for (int i = 0; i < quadratic_nodes; ++i) {
    const double r = u[2 * cell.nodes[i]], z = u[2 * cell.nodes[i] + 1];
    f.rr += point.gradient[i][0] * r;
    f.rz += point.gradient[i][1] * r;
    f.zr += point.gradient[i][0] * z;
    f.zz += point.gradient[i][1] * z;
    f.tt += point.shape[i] * r;
  }
  f.tt = 1.0 + f.tt / point.radius;
  return f;
}

bool turned_over(const Gradient<double>& f) {
  return !(jacobian_of(f) > 0.0 && f.tt > 0.0);
}

Symmetric<double> right_cauchy_green_of(const Gradient<double>& f) {
  return {f.rr * f.rr + f.zr * f.zr, f.rz * f.rz + f.zz * f.zz, f.tt * f.tt,
          f.rr * f.rz + f.zr * f.zz};
}

/// A : B with B = (rr, zz, tt, rz) of a vector.
double contract(const Symmetric<double>& a, const Eigen::Vector4d& b) {
  return a.rr * b[0] + a.zz * b[1] + a.tt * b[2] + 2.0 * a.rz * b[3];
}

}  // namespace

DilatationProjection dilatation_projection(const QuadraticBody& body, const QuadraticCell& cell) {
  Eigen::Matrix<double, quadratic_points, 3> basis;
  Eigen::Matrix<double, quadratic_points, 1> weight;
  for (int q = 0; q < quadratic_points; ++q) {
    double height = 0.0;
    for (int i = 0; i < quadratic_nodes; ++i)
      height += cell.points[q].shape[i] * body.position[cell.nodes[i]][1];
    weight[q] = cell.points[q].weight;
    basis.row(q) << 1.0, cell.points[q].radius, height;
  }
  // About the centre and in units of the cell, for the conditioning of the 3 × 3 matrix.
  for (int k = 1; k < 3; ++k) {
    basis.col(k).array() -= basis.col(k).mean();
    basis.col(k) /= basis.col(k).cwiseAbs().maxCoeff();
  }
  const Eigen::Matrix<double, 3, quadratic_points> weighted =
      basis.transpose() * weight.asDiagonal();
  return basis * (weighted * basis).inverse() * weighted;
}

QuadraticMotion::QuadraticMotion(const QuadraticCell& cell, const Eigen::VectorXd& u,
                                 const DilatationProjection* projection)
    : cell_(cell), projection_(projection) {
  for (int q = 0; q < quadratic_points; ++q) {
    gradient_[q] = gradient_at(cell, cell.points[q], u);
    inverted_ = inverted_ || turned_over(gradient_[q]);
    jacobian_[q] = jacobian_of(gradient_[q]);
  }
  ratio_ = jacobian_;
  scale_.fill(1.0);
  if (!projection) return;
  ratio_ = *projection * jacobian_;
  inverted_ = inverted_ || !(ratio_.minCoeff() > 0.0);
  for (int q = 0; q < quadratic_points; ++q) scale_[q] = std::cbrt(ratio_[q] / jacobian_[q]);
}

Gradient<double> QuadraticMotion::gradient(int q) const {
  const Gradient<double>& f = gradient_[q];
  if (!projection_) return f;
  const double a = scale_[q];
  return {a * f.rr, a * f.rz, a * f.zr, a * f.zz, a * f.tt};
}

Symmetric<double> QuadraticMotion::right_cauchy_green(int q) const {
  return right_cauchy_green_of(gradient(q));
}

StrainRows QuadraticMotion::own_rows(int q) const {
  const QuadraticCell::Point& point = cell_.points[q];
  const Gradient<double>& f = gradient_[q];
  StrainRows b;
  for (int i = 0; i < quadratic_nodes; ++i) {
    const double r = point.gradient[i][0], z = point.gradient[i][1];
    b.col(2 * i) << f.rr * r, f.rz * z, f.tt * point.shape[i] / point.radius, f.rr * z + f.rz * r;
    b.col(2 * i + 1) << f.zr * r, f.zz * z, 0.0, f.zr * z + f.zz * r;
  }
  return b;
}

/// ∂ ln J = F⁻ᵀ : ∂F and ∂ ln Θ = Σ A J ∂ ln J/Θ.
QuadraticMotion::Rates QuadraticMotion::rates() const {
  Rates rates;
  for (int q = 0; q < quadratic_points; ++q) {
    const QuadraticCell::Point& point = cell_.points[q];
    const Gradient<double>& f = gradient_[q];
    const double in_plane = f.rr * f.zz - f.rz * f.zr;
    for (int i = 0; i < quadratic_nodes; ++i) {
      const double r = point.gradient[i][0], z = point.gradient[i][1];
      rates.own[q][2 * i] =
          (r * f.zz - z * f.zr) / in_plane + point.shape[i] / (point.radius * f.tt);
      rates.own[q][2 * i + 1] = (z * f.rr - r * f.rz) / in_plane;
    }
  }
  for (int q = 0; q < quadratic_points; ++q) {
    rates.shared[q].setZero();
    for (int p = 0; p < quadratic_points; ++p)
      rates.shared[q] += (*projection_)(q, p) * jacobian_[p] / ratio_[q] * rates.own[p];
  }
  return rates;
}

/// ∂Ē = α² (∂E + ⅓ C ∂ ln(Θ/J)).
std::array<StrainRows, quadratic_points> QuadraticMotion::strain_rows() const {
  std::array<StrainRows, quadratic_points> rows;
  for (int q = 0; q < quadratic_points; ++q) rows[q] = own_rows(q);
  if (!projection_) return rows;
  const Rates of = rates();
  for (int q = 0; q < quadratic_points; ++q) {
    const Symmetric<double> c = right_cauchy_green_of(gradient_[q]);
    const Eigen::Vector4d strain(c.rr, c.zz, c.tt, 2.0 * c.rz);
    rows[q] += strain / 3.0 * (of.shared[q] - of.own[q]).transpose();
    rows[q] *= scale_[q] * scale_[q];
  }
  return rows;
}

void QuadraticMotion::add_geometric_stiffness(int q, const Eigen::Vector4d& stress,
                                              CellMatrix& stiffness) const {
  const QuadraticCell::Point& point = cell_.points[q];
  const Eigen::Vector4d s = scale_[q] * scale_[q] * stress;
  for (int i = 0; i < quadratic_nodes; ++i) {
    const auto& gi = point.gradient[i];
    const double along_r = s[0] * gi[0] + s[3] * gi[1], along_z = s[3] * gi[0] + s[1] * gi[1];
    const double hoop = s[2] * point.shape[i] / (point.radius * point.radius);
    for (int j = 0; j < quadratic_nodes; ++j) {
      const double shared = along_r * point.gradient[j][0] + along_z * point.gradient[j][1];
      stiffness(2 * i, 2 * j) += shared + hoop * point.shape[j];
      stiffness(2 * i + 1, 2 * j + 1) += shared;
    }
  }
}

/// With a = ln(Θ/J), t = ⅓ S̄:C̄ and s = α² S̄:∂E, what S̄:∂²Ē has beside α² S̄:∂²E:
///
///   ⅔ (∂a s + s ∂a) + ⅔ t ∂a ∂a + t ∂²a,
///   ∂²a = ∂²Θ/Θ − ∂lnΘ ∂lnΘ − ∂²J/J + ∂lnJ ∂lnJ,   ∂²Θ = A ∂²J
void QuadraticMotion::add_dilatation_stiffness(const Stresses& stress,
                                               CellMatrix& stiffness) const {
  if (!projection_) return;
  const Rates of = rates();
  Eigen::Matrix<double, quadratic_points, 1> curvature;
  curvature.setZero();
  for (int q = 0; q < quadratic_points; ++q) {
    const Row change = of.shared[q] - of.own[q];
    const double square = scale_[q] * scale_[q];
    const double t = contract(right_cauchy_green(q), stress[q]) / 3.0;
    const Row s = square * (own_rows(q).transpose() * stress[q]);
    stiffness += (2.0 / 3.0) * (change * s.transpose() + s * change.transpose());
    stiffness += (2.0 / 3.0) * t * change * change.transpose();
    stiffness += t * (of.own[q] * of.own[q].transpose());
    stiffness -= t * (of.shared[q] * of.shared[q].transpose());
    curvature += t / ratio_[q] * projection_->row(q).transpose();
    curvature[q] -= t / jacobian_[q];
  }
  for (int q = 0; q < quadratic_points; ++q) add_jacobian_curvature(q, curvature[q], stiffness);
}

/// ∂²J of J = (F_rr F_zz − F_rz F_zr) F_tt.
void QuadraticMotion::add_jacobian_curvature(int q, double weight, CellMatrix& stiffness) const {
  const QuadraticCell::Point& point = cell_.points[q];
  const Gradient<double>& f = gradient_[q];
  for (int i = 0; i < quadratic_nodes; ++i) {
    const double ri = point.gradient[i][0], zi = point.gradient[i][1];
    const double hoop_i = point.shape[i] / point.radius, plane_i = ri * f.zz - zi * f.zr;
    for (int j = 0; j < quadratic_nodes; ++j) {
      const double rj = point.gradient[j][0], zj = point.gradient[j][1];
      const double hoop_j = point.shape[j] / point.radius, plane_j = rj * f.zz - zj * f.zr;
      const double mixed = (ri * zj - zi * rj) * f.tt + hoop_i * (zj * f.rr - rj * f.rz);
      stiffness(2 * i, 2 * j) += weight * (plane_i * hoop_j + hoop_i * plane_j);
      stiffness(2 * i, 2 * j + 1) += weight * mixed;
      stiffness(2 * j + 1, 2 * i) += weight * mixed;
    }
  }
}

}  // namespace rebound::fem
