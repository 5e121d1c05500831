#include "fem/element_tests/linear_contact.hpp"

#include <cmath>

#include "fem/implicit/equilibrium.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {

double linear_contact_force(const Mesh& mesh, const LinearContact& contact) {
  const bool half = contact.platens == 2;
  const QuadraticBody body = quadratic_body(mesh, {.radius = contact.radius, .mass = 1.0});
  const BodyForces forces(body, contact.material, ContactInertia::kept);
  SystemMatrix stiffness = forces.mass();
  Eigen::VectorXd at_rest;
  forces.linearise(Eigen::VectorXd::Zero(forces.size()), 0.0, at_rest, stiffness);

  EquilibriumTask task;
  task.linearise = [&](const Eigen::VectorXd& u, Eigen::VectorXd& residual, SystemMatrix& matrix) {
    residual = stiffness.times(u);
    matrix.set(1.0, stiffness);
    return BodyForces::Outcome::done;
  };
  task.force_scale = 0.1 * contact.material.youngs_modulus *
                     std::sqrt(contact.radius * contact.approach) * contact.approach;
  task.rounding = forces.rounding();
  task.needs_contact = true;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(forces.size());
  for (int node = 0; node < body.node_count(); ++node) {
    u[2 * node + 1] = -contact.approach;
    if (half && body.position[node][1] > (1.0 - 1e-6) * contact.radius)
      task.prescribed.emplace_back(2 * node + 1, -contact.approach);
  }
  if (!half) {
    task.load = forces.axial_mass() / body.mass;
    task.travel = -contact.approach;
  }
  EquilibriumSearch search(body, forces.mass());
  ActiveSet held(body);
  Eigen::VectorXd reaction;
  const auto found = search.solve(task, u, held, reaction);
  if (!found.converged) throw Error(ExitCode::solver_failed, "linear contact: " + found.failure);
  double force = 0.0;
  held.each_held(u, [&](int unknown, double) { force += reaction[unknown]; });
  return force;
}

}  // namespace rebound::fem
