#include "fem/verification/linear_contact.hpp"

#include <cmath>

#include "fem/implicit/equilibrium.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound::fem {

double linear_contact_force(const LinearContact& problem) {
  const bool half = problem.platens == 2;
  const QuadraticBody body = quadratic_body(
      generate_sphere_mesh({.radius = problem.radius,
                            .cells = problem.cells,
                            .grading = problem.grading,
                            .part = half ? SpherePart::lower_half : SpherePart::whole}),
      {.radius = problem.radius, .mass = 1.0});
  const Material material{.youngs_modulus = problem.youngs_modulus,
                          .poisson_ratio = problem.poisson_ratio};
  const BodyForces forces(body, material, ContactInertia::kept);
  SystemMatrix stiffness = forces.empty_matrix();
  Eigen::VectorXd at_rest;
  forces.linearise(Eigen::VectorXd::Zero(forces.size()), {}, at_rest, stiffness);

  EquilibriumTask task;
  task.linearise = [&](const Eigen::VectorXd& u, Eigen::VectorXd& residual, SystemMatrix& matrix) {
    residual = stiffness.selfadjointView<Eigen::Lower>() * u;
    matrix = stiffness;
    return BodyForces::Outcome::done;
  };
  task.force_scale = 0.1 * problem.youngs_modulus * std::sqrt(problem.radius * problem.approach) *
                     problem.approach;
  task.rounding = forces.rounding();
  task.needs_contact = true;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(forces.size());
  for (int node = 0; node < body.node_count(); ++node) {
    u[2 * node + 1] = -problem.approach;
    if (half && body.position[node][1] > (1.0 - 1e-6) * problem.radius)
      task.prescribed.emplace_back(2 * node + 1, -problem.approach);
  }
  if (!half) {
    task.load = forces.axial_mass() / body.mass;
    task.travel = -problem.approach;
  }
  EquilibriumSearch search(body, forces.empty_matrix());
  HeldNodes held(body);
  Eigen::VectorXd reaction;
  const auto found = search.solve(task, u, held, reaction);
  if (!found.converged) throw Error(ExitCode::solver_failed, "linear contact: " + found.failure);
  double force = 0.0;
  held.each_held(u, [&](int unknown, double) { force += reaction[unknown]; });
  return force;
}

}  // namespace rebound::fem
