#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/element_tests/bilinear_forces.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/fem_problem.hpp"
#include "tests/support/meshes.hpp"

namespace rebound::test {

/// Numbers in [−1, 1] from a fixed seed.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return spread_(engine_); }
  double between(double low, double high) { return low + (high - low) * 0.5 * (1.0 + (*this)()); }
  std::vector<double> vector(std::size_t size, double scale) {
    std::vector<double> values(size);
    for (double& value : values) value = scale * (*this)();
    return values;
  }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> spread_{-1.0, 1.0};
};

/// Slope of log(remainder) over log(step) as the step falls; the smallest of
/// the slopes between neighbouring steps. 2 shows that `remainder` leaves out
/// exactly the second and higher orders.
template <class Remainder>
double smallest_slope(const Remainder& remainder, double first_step) {
  double smallest = 1e9;
  double step = first_step;
  double before = std::abs(remainder(step));
  for (int i = 0; i < 3; ++i) {
    step *= 0.25;
    const double now = std::abs(remainder(step));
    smallest = std::min(smallest, std::log(before / now) / std::log(4.0));
    before = now;
  }
  return smallest;
}

/// A cylinder 1 m by 1.2 m whose inner vertices are moved by a fifth of a cell.
inline Mesh distorted_cylinder() {
  constexpr int across = 4, along = 5;
  Mesh mesh =
      cylinder({.radius = 1.0, .length = 1.2, .cells_across = across, .cells_along = along});
  Random random(7);
  for (int j = 1; j < along; ++j)
    for (int i = 1; i < across; ++i) {
      auto& vertex = mesh.vertices[j * (across + 1) + i];
      vertex[0] += 0.05 * random();
      vertex[1] += 0.05 * random();
    }
  return mesh;
}

/// Every model of the list.
inline const std::vector<ElasticModel> elastic_models = [] {
  std::vector<ElasticModel> models;
  for (const ElasticModelCard& card : rebound::elastic_models()) models.push_back(card.model);
  return models;
}();

/// μ = 1 Pa, λ = 4 Pa; laws of principal stretches with terms of both signs.
inline Material unit_material(ElasticModel elastic = {}) {
  Material material{.elastic = elastic, .youngs_modulus = 2.8, .poisson_ratio = 0.4};
  if (shape_of(elastic) == ElasticShape::second_share) material.second_share = 0.25;
  if (has_terms(elastic))
    material.terms = {{.weight = 3.0, .exponent = 4.0}, {.weight = 1.0, .exponent = -2.0}};
  return material;
}

/// The common case of the verification suite: R = 33.1 mm, m = 89.6 g,
/// E = 10 MPa, ν = 0.4.
inline FemProblem common_case(double speed) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = speed;
  problem.material = {.youngs_modulus = 10e6, .poisson_ratio = 0.4};
  return problem;
}

using KernelCase = fem::BilinearForces;

/// u_r = (a − 1) R, u_z = (b − 1) Z.
inline std::vector<double> stretched(const fem::Discretisation& body, double a, double b) {
  std::vector<double> u(2 * (body.position.size() + 1), 0.0);
  for (int node = 0; node < body.node_count(); ++node) {
    u[2 * node] = (a - 1.0) * body.position[node][0];
    u[2 * node + 1] = (b - 1.0) * body.position[node][1];
  }
  return u;
}

}  // namespace rebound::test
