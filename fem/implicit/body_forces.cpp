#include "fem/implicit/body_forces.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {
namespace {

constexpr int cell_unknowns = 2 * quadratic_nodes;
constexpr int cell_entries = cell_unknowns * (cell_unknowns + 1) / 2;
using Triplet = Eigen::Triplet<double>;

int unknown_of(const QuadraticCell& cell, int local) {
  return 2 * cell.nodes[local / 2] + local % 2;
}

/// Strain increments (E_rr, E_zz, E_tt, 2 E_rz) of the cell's unknowns.
using StrainRows = Eigen::Matrix<double, 4, cell_unknowns>;

StrainRows strain_rows(const QuadraticCell::Point& point, const Gradient<double>& f) {
  StrainRows b;
  for (int i = 0; i < quadratic_nodes; ++i) {
    const double r = point.gradient[i][0], z = point.gradient[i][1];
    b.col(2 * i) << f.rr * r, f.rz * z, f.tt * point.shape[i] / point.radius, f.rr * z + f.rz * r;
    b.col(2 * i + 1) << f.zr * r, f.zz * z, 0.0, f.zr * z + f.zz * r;
  }
  return b;
}

}  // namespace

BodyForces::BodyForces(const QuadraticBody& body, const Material& material, ContactInertia inertia)
    : body_(body), law_(material) {
  states_.resize(body.cells.size() * quadratic_points * law_.branch_count());
  make_pattern(inertia);
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size());
  for (int node = 0; node < body.node_count(); ++node) unit[2 * node + 1] = 1.0;
  axial_mass_ = times_mass(unit);
}

void BodyForces::make_pattern(ContactInertia inertia) {
  // What stands for the axial velocity of each node in the kinetic energy.
  std::vector<std::vector<std::pair<int, double>>> axial(body_.node_count());
  for (int node = 0; node < body_.node_count(); ++node) axial[node] = {{node, 1.0}};
  if (inertia == ContactInertia::removed)
    for (const auto& [node, behind] : body_.contact) axial[node] = {{behind[0], 2.0}, {behind[1], -1.0}};

  std::vector<Triplet> mass, all;
  const auto add = [](std::vector<Triplet>& list, int i, int j, double value) {
    if (i >= j) list.emplace_back(i, j, value);
  };
  for (const auto& cell : body_.cells) {
    for (int i = 0; i < cell_unknowns; ++i)
      for (int j = 0; j < cell_unknowns; ++j)
        add(all, unknown_of(cell, i), unknown_of(cell, j), 0.0);
    for (int i = 0; i < quadratic_nodes; ++i)
      for (int j = 0; j < quadratic_nodes; ++j) {
        double m = 0.0;
        for (const auto& point : cell.points) m += point.weight * point.shape[i] * point.shape[j];
        m *= body_.density;
        add(mass, 2 * cell.nodes[i], 2 * cell.nodes[j], m);
        for (const auto& [a, share_a] : axial[cell.nodes[i]])
          for (const auto& [b, share_b] : axial[cell.nodes[j]])
            add(mass, 2 * a + 1, 2 * b + 1, share_a * share_b * m);
      }
  }
  mass_.resize(size(), size());
  mass_.setFromTriplets(mass.begin(), mass.end());
  for (const Triplet& entry : mass) all.emplace_back(entry.row(), entry.col(), 0.0);
  pattern_.resize(size(), size());
  pattern_.setFromTriplets(all.begin(), all.end());

  const auto place = [&](int row, int column) {
    const int* rows = pattern_.innerIndexPtr();
    const int* begin = rows + pattern_.outerIndexPtr()[column];
    const int* end = rows + pattern_.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(begin, end, row) - rows);
  };
  mass_values_.assign(pattern_.nonZeros(), 0.0);
  for (int column = 0; column < mass_.outerSize(); ++column)
    for (SystemMatrix::InnerIterator it(mass_, column); it; ++it)
      mass_values_[place(static_cast<int>(it.row()), column)] = it.value();
  places_.reserve(body_.cells.size() * cell_entries);
  for (const auto& cell : body_.cells)
    for (int i = 0; i < cell_unknowns; ++i)
      for (int j = 0; j <= i; ++j) {
        const int a = unknown_of(cell, i), b = unknown_of(cell, j);
        places_.push_back(place(std::max(a, b), std::min(a, b)));
      }
}

Eigen::VectorXd BodyForces::times_mass(const Eigen::VectorXd& v) const {
  return mass_.selfadjointView<Eigen::Lower>() * v;
}

Symmetric<double> BodyForces::right_cauchy_green(const QuadraticCell& cell,
                                                 const QuadraticCell::Point& point,
                                                 const Eigen::VectorXd& u,
                                                 Gradient<double>& f) const {
  f = {1.0, 0.0, 0.0, 1.0, 0.0};
  for (int i = 0; i < quadratic_nodes; ++i) {
    const double r = u[2 * cell.nodes[i]], z = u[2 * cell.nodes[i] + 1];
    f.rr += point.gradient[i][0] * r;
    f.rz += point.gradient[i][1] * r;
    f.zr += point.gradient[i][0] * z;
    f.zz += point.gradient[i][1] * z;
    f.tt += point.shape[i] * r;
  }
  f.tt = 1.0 + f.tt / point.radius;
  return {f.rr * f.rr + f.zr * f.zr, f.rz * f.rz + f.zz * f.zz, f.tt * f.tt,
          f.rr * f.rz + f.zr * f.zz};
}

namespace {

bool inverted(const Gradient<double>& f) { return !(jacobian_of(f) > 0.0 && f.tt > 0.0); }

void add_forces(const QuadraticCell& cell, const Eigen::Matrix<double, cell_unknowns, 1>& local,
                Eigen::VectorXd& force) {
  for (int i = 0; i < cell_unknowns; ++i) force[unknown_of(cell, i)] += local[i];
}

}  // namespace

BodyForces::Outcome BodyForces::forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  force.setZero(size());
  const BranchState* states = states_.data();
  for (const auto& cell : body_.cells) {
    Eigen::Matrix<double, cell_unknowns, 1> local;
    local.setZero();
    for (const auto& point : cell.points) {
      Gradient<double> f;
      const auto c = right_cauchy_green(cell, point, u, f);
      if (inverted(f)) return Outcome::inverted;
      const Symmetric<double> s = law_.stress(c, states);
      states += law_.branch_count();
      local += point.weight * (strain_rows(point, f).transpose() *
                               Eigen::Vector4d(s.rr, s.zz, s.tt, s.rz));
    }
    add_forces(cell, local, force);
  }
  return Outcome::done;
}

BodyForces::Outcome BodyForces::linearise(const Eigen::VectorXd& u, const Weights& weights,
                                          Eigen::VectorXd& force, SystemMatrix& matrix) const {
  force.setZero(size());
  double* values = matrix.valuePtr();
  for (std::size_t i = 0; i < mass_values_.size(); ++i) values[i] = weights.mass * mass_values_[i];
  const BranchState* states = states_.data();
  const int* place = places_.data();
  for (const auto& cell : body_.cells) {
    Eigen::Matrix<double, cell_unknowns, 1> local;
    Eigen::Matrix<double, cell_unknowns, cell_unknowns> stiffness;
    local.setZero();
    stiffness.setZero();
    for (const auto& point : cell.points) {
      Gradient<double> f;
      const auto c = right_cauchy_green(cell, point, u, f);
      if (inverted(f)) return Outcome::inverted;
      const StressResponse response = law_.respond(c, states);
      states += law_.branch_count();
      const StrainRows b = strain_rows(point, f);
      const Eigen::Vector4d s = point.weight * response.stress;
      local.noalias() += b.transpose() * s;
      const StrainRows weighted = point.weight * response.tangent * b;
      stiffness.noalias() += b.transpose() * weighted;
      for (int i = 0; i < quadratic_nodes; ++i) {
        const auto& gi = point.gradient[i];
        const double along_r = s[0] * gi[0] + s[3] * gi[1], along_z = s[3] * gi[0] + s[1] * gi[1];
        const double hoop = s[2] * point.shape[i] / (point.radius * point.radius);
        for (int j = 0; j <= i; ++j) {
          const double shared = along_r * point.gradient[j][0] + along_z * point.gradient[j][1];
          stiffness(2 * i, 2 * j) += shared + hoop * point.shape[j];
          stiffness(2 * i + 1, 2 * j + 1) += shared;
        }
      }
    }
    add_forces(cell, local, force);
    for (int i = 0; i < cell_unknowns; ++i)
      for (int j = 0; j <= i; ++j) values[*place++] += weights.stiffness * stiffness(i, j);
  }
  return Outcome::done;
}

void BodyForces::accept(const Eigen::VectorXd& u) {
  if (law_.branch_count() == 0) return;
  BranchState* states = states_.data();
  for (const auto& cell : body_.cells)
    for (const auto& point : cell.points) {
      Gradient<double> f;
      law_.accept(right_cauchy_green(cell, point, u, f), states);
      states += law_.branch_count();
    }
}

double BodyForces::rounding() const {
  return 1e-14 * law_.constants().instantaneous.bulk * body_.height * body_.height;
}

double BodyForces::stored_energy(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  for (const auto& cell : body_.cells)
    for (const auto& point : cell.points) {
      Gradient<double> f;
      sum += point.weight * law_.stored_energy(right_cauchy_green(cell, point, u, f));
    }
  return sum;
}

}  // namespace rebound::fem
