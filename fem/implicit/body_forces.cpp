#include "fem/implicit/body_forces.hpp"

namespace rebound::fem {
namespace {

int unknown_of(const QuadraticCell& cell, int local) {
  return 2 * cell.nodes[local / 2] + local % 2;
}

}  // namespace

BodyForces::BodyForces(const QuadraticBody& body, const Material& material, ContactInertia inertia)
    : body_(body), law_(material), mass_(body, inertia) {
  states_.resize(body.cells.size() * quadratic_points * law_.branch_count());
  if (law_.branch_count() > 0)
    last_strains_.assign(body.cells.size() * quadratic_points, {1.0, 1.0, 1.0, 0.0});
  if (law_.constants().mean_dilatation)
    for (const QuadraticCell& cell : body.cells)
      projections_.push_back(dilatation_projection(body, cell));
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size());
  for (int node = 0; node < body.node_count(); ++node) unit[2 * node + 1] = 1.0;
  axial_mass_ = mass_.times(unit);
}

QuadraticMotion BodyForces::motion_of(std::size_t cell, const Eigen::VectorXd& u) const {
  return {body_.cells[cell], u, projections_.empty() ? nullptr : &projections_[cell]};
}

BodyForces::Outcome BodyForces::forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  force.setZero(size());
  const BranchState* states = states_.data();
  for (std::size_t k = 0; k < body_.cells.size(); ++k) {
    const QuadraticCell& cell = body_.cells[k];
    const QuadraticMotion motion = motion_of(k, u);
    if (motion.inverted()) return Outcome::inverted;
    const auto rows = motion.strain_rows();
    for (int q = 0; q < quadratic_points; ++q) {
      const Symmetric<double> s = law_.stress(motion.right_cauchy_green(q), states);
      states += law_.branch_count();
      const Eigen::Matrix<double, quadratic_unknowns, 1> local =
          cell.points[q].weight * rows[q].transpose() * Eigen::Vector4d(s.rr, s.zz, s.tt, s.rz);
      for (int i = 0; i < quadratic_unknowns; ++i) force[unknown_of(cell, i)] += local[i];
    }
  }
  return Outcome::done;
}

BodyForces::Outcome BodyForces::linearise(const Eigen::VectorXd& u, double mass_weight,
                                          Eigen::VectorXd& force, SystemMatrix& matrix) const {
  force.setZero(size());
  matrix.set(mass_weight, mass_);
  const BranchState* states = states_.data();
  for (std::size_t k = 0; k < body_.cells.size(); ++k) {
    const QuadraticCell& cell = body_.cells[k];
    const QuadraticMotion motion = motion_of(k, u);
    if (motion.inverted()) return Outcome::inverted;
    Eigen::Matrix<double, quadratic_unknowns, 1> local;
    CellMatrix stiffness;
    local.setZero();
    stiffness.setZero();
    const auto rows = motion.strain_rows();
    QuadraticMotion::Stresses stresses;
    for (int q = 0; q < quadratic_points; ++q) {
      const double weight = cell.points[q].weight;
      const StressResponse response = law_.respond(motion.right_cauchy_green(q), states);
      states += law_.branch_count();
      stresses[q] = weight * response.stress;
      local.noalias() += rows[q].transpose() * stresses[q];
      const StrainRows weighted = weight * response.tangent * rows[q];
      stiffness.noalias() += rows[q].transpose() * weighted;
      motion.add_geometric_stiffness(q, stresses[q], stiffness);
    }
    motion.add_dilatation_stiffness(stresses, stiffness);
    std::array<int, quadratic_unknowns> unknowns;
    for (int i = 0; i < quadratic_unknowns; ++i) {
      unknowns[i] = unknown_of(cell, i);
      force[unknowns[i]] += local[i];
    }
    matrix.add(unknowns, {stiffness.data(), quadratic_unknowns * quadratic_unknowns});
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
