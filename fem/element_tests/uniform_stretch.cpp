#include "fem/element_tests/uniform_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/element_tests/bilinear_forces.hpp"
#include "fem/implicit/body_forces.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

template <class Body>
double top_of(const Body& body) {
  double top = 0.0;
  for (const auto& p : body.position) top = std::max(top, p[1]);
  return top;
}

template <class Body, class Forces>
UniformStress stress_from(const Body& body, double top, const Forces& force) {
  constexpr double near = 1e-9;
  double side = 0.0, end = 0.0, inside = 0.0, outside = 0.0;
  for (int node = 0; node < body.node_count(); ++node) {
    const auto& [r, z] = body.position[node];
    const double fr = force[2 * node], fz = force[2 * node + 1];
    const bool on_side = r > 1.0 - near, on_end = z > top - near;
    if (on_side) side += fr;
    if (on_end) end += fz;
    // On the axis the symmetry carries f_r, on the base the support carries f_z.
    double& largest = on_side || on_end || z < near ? outside : inside;
    largest = std::max({largest, r > near ? std::abs(fr) : 0.0, std::abs(fz)});
  }
  return {side / (2.0 * std::numbers::pi * top), end / std::numbers::pi,
          outside > 0.0 ? inside / outside : 0.0};
}

/// scale (s − 1) X of every node.
template <class Body, class Values>
void place_nodes(const Body& body, const UniformStretch& stretch, double scale, Values& values) {
  for (int node = 0; node < body.node_count(); ++node) {
    values[2 * node] = scale * (stretch.radial - 1.0) * body.position[node][0];
    values[2 * node + 1] = scale * (stretch.axial - 1.0) * body.position[node][1];
  }
}

std::vector<UniformStress> follow_bilinear(const Mesh& mesh, const Material& material,
                                           const StretchHistory& history) {
  const Discretisation body = discretise(mesh, 1.0);
  BilinearForces forces(body, material, choose_cell_kernel(), history.step);
  const double top = top_of(body);
  std::vector<double> u(forces.size(), 0.0), v(forces.size(), 0.0);
  forces.force(u, v.data());
  UniformStretch before;
  std::vector<UniformStress> stresses;
  for (const UniformStretch& stretch : history.stretches) {
    place_nodes(body, stretch, 1.0, u);
    place_nodes(body, {1.0 + stretch.radial - before.radial, 1.0 + stretch.axial - before.axial},
                1.0 / history.step, v);
    stresses.push_back(stress_from(body, top, forces.force(u, v.data())));
    before = stretch;
  }
  return stresses;
}

std::vector<UniformStress> follow_nine_node(const Mesh& mesh, const Material& material,
                                            const StretchHistory& history) {
  const QuadraticBody body = quadratic_body(mesh, {.mass = 1.0});
  BodyForces forces(body, material, ContactInertia::kept);
  forces.law().set_step(history.step);
  const double top = top_of(body);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(forces.size()), force;
  std::vector<UniformStress> stresses;
  for (const UniformStretch& stretch : history.stretches) {
    place_nodes(body, stretch, 1.0, u);
    if (forces.forces(u, force) != BodyForces::Outcome::done)
      throw Error(ExitCode::solver_failed, "a uniform stretch inverted a cell");
    forces.accept(u);
    stresses.push_back(stress_from(body, top, force));
  }
  return stresses;
}

}  // namespace

std::vector<UniformStress> follow_stretches(const Mesh& mesh, CellKind cells,
                                            const Material& material,
                                            const StretchHistory& history) {
  return cells == CellKind::bilinear ? follow_bilinear(mesh, material, history)
                                     : follow_nine_node(mesh, material, history);
}

}  // namespace rebound::fem
