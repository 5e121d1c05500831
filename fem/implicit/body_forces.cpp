#include "fem/implicit/body_forces.hpp"

namespace rebound::fem {
namespace {

constexpr int cell_unknowns = 2 * quadratic_nodes;

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

bool inverted(const Gradient<double>& f) {
  return !(jacobian_of(f) > 0.0 && f.tt > 0.0);
}

}  // namespace

BodyForces::BodyForces(const QuadraticBody& body, const Material& material, ContactInertia inertia)
    : body_(body), law_(material), mass_(body, inertia) {
  states_.resize(body.cells.size() * quadratic_points * law_.branch_count());
  if (law_.branch_count() > 0)
    last_strains_.assign(body.cells.size() * quadratic_points, {1.0, 1.0, 1.0, 0.0});
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size());
  for (int node = 0; node < body.node_count(); ++node) unit[2 * node + 1] = 1.0;
  axial_mass_ = mass_.times(unit);
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

BodyForces::Outcome BodyForces::forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  force.setZero(size());
  bool done = true;
  each(u, [&](const auto& cell, const auto& point, const auto& f, const auto& c, auto branch) {
    done = done && !inverted(f);
    if (!done) return;
    const Symmetric<double> s = law_.stress(c, states_.data() + branch);
    const Eigen::Matrix<double, cell_unknowns, 1> local =
        point.weight * strain_rows(point, f).transpose() * Eigen::Vector4d(s.rr, s.zz, s.tt, s.rz);
    for (int i = 0; i < cell_unknowns; ++i) force[unknown_of(cell, i)] += local[i];
  });
  return done ? Outcome::done : Outcome::inverted;
}

BodyForces::Outcome BodyForces::linearise(const Eigen::VectorXd& u, double mass_weight,
                                          Eigen::VectorXd& force, SystemMatrix& matrix) const {
  force.setZero(size());
  matrix.set(mass_weight, mass_);
  const BranchState* states = states_.data();
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
        for (int j = 0; j < quadratic_nodes; ++j) {
          const double shared = along_r * point.gradient[j][0] + along_z * point.gradient[j][1];
          stiffness(2 * i, 2 * j) += shared + hoop * point.shape[j];
          stiffness(2 * i + 1, 2 * j + 1) += shared;
        }
      }
    }
    std::array<int, cell_unknowns> unknowns;
    for (int i = 0; i < cell_unknowns; ++i) {
      unknowns[i] = unknown_of(cell, i);
      force[unknowns[i]] += local[i];
    }
    matrix.add(unknowns, {stiffness.data(), cell_unknowns * cell_unknowns});
  }
  return Outcome::done;
}

void BodyForces::accept(const Eigen::VectorXd& u) {
  if (law_.branch_count() == 0) return;
  auto last = last_strains_.begin();
  each(u, [&](const auto&, const auto& point, const auto&, const auto& c, auto branch) {
    const Symmetric<double> before = law_.relaxed_stress(states_.data() + branch);
    law_.accept(c, states_.data() + branch);
    const Symmetric<double> after = law_.relaxed_stress(states_.data() + branch);
    // dE = ½ dC, and half of the sum of both ends
    relaxed_work_ +=
        0.25 * point.weight *
        ((before.rr + after.rr) * (c.rr - last->rr) + (before.zz + after.zz) * (c.zz - last->zz) +
         (before.tt + after.tt) * (c.tt - last->tt) +
         2.0 * (before.rz + after.rz) * (c.rz - last->rz));
    *last++ = c;
  });
}

BodyForces::BranchEnergies BodyForces::branch_energies(const Eigen::VectorXd& u) const {
  BranchEnergies sum;
  if (law_.branch_count() == 0) return sum;
  sum.taken = -relaxed_work_;
  each(u, [&](const auto&, const auto& point, const auto&, const auto& c, auto branch) {
    sum.taken += point.weight * law_.driving_energy(c);
    sum.held += point.weight * law_.held_energy(c, states_.data() + branch);
  });
  return sum;
}

double BodyForces::rounding() const {
  return 1e-14 * law_.constants().instantaneous.bulk * body_.height * body_.height;
}

double BodyForces::stored_energy(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  each(u, [&](const auto&, const auto& point, const auto&, const auto& c, auto) {
    sum += point.weight * law_.stored_energy(c);
  });
  return sum;
}

}  // namespace rebound::fem
