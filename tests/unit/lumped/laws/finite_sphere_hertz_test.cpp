#include "lumped/laws/finite_sphere_hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

// R = 33.1 mm, m = 89.6 g, E = 10 MPa, ν = 0.4.
constexpr double radius = 0.0331, modulus = 10e6, nu = 0.4;
const double stiffness = 4.0 / 3.0 * modulus / (1.0 - nu * nu) * std::sqrt(radius);

FiniteSphereHertz law_of(double at_radius) {
  return FiniteSphereHertz::from({{"stiffness", stiffness},
                                  {"dissipation_time", 0.0},
                                  {"poisson_ratio", nu},
                                  {"radius", at_radius}});
}

TEST(FiniteSphereHertzTest, SatisfiesItsDefinition) {
  const FiniteSphereHertz law = law_of(radius);
  for (double x : {1e-7, 1e-4, 1e-3, 4e-3, 8e-3}) {
    const double f = law.elastic_force(x);
    EXPECT_NEAR((std::pow(f / stiffness, 2.0 / 3.0) - 0.3739 * f / (modulus * radius)) / x, 1.0,
                1e-12);
  }
}

// Deflection of the centre of mass over Hertz's approach, by two independent
// computations of the sphere on a plate: Green function of the sphere (0.0569,
// 0.1187 less) and finite elements (C = 0.380, 0.374 ± 0.005).
TEST(FiniteSphereHertzTest, CentreMovesLessThanHertz) {
  const FiniteSphereHertz law = law_of(radius);
  for (const auto& [a, s] : {std::pair{0.1, 0.0569}, std::pair{0.2, 0.1187}}) {
    const double hertz = a * a * radius, f = stiffness * std::pow(hertz, 1.5);
    double low = 0.5 * hertz, high = hertz;
    for (int i = 0; i < 60; ++i)
      (law.elastic_force(0.5 * (low + high)) < f ? low : high) = 0.5 * (low + high);
    EXPECT_NEAR(1.0 - low / hertz, s, 0.003) << a;
  }
}

// Change against Hertz in contact time and peak force, linear and quasi-static,
// from the Green function of the sphere: −2.32/−4.64/−6.32 %, +3.21/+6.71/+9.41 %.
TEST(FiniteSphereHertzTest, ElasticImpacts) {
  const double targets[][3] = {
      {0.1, -0.0232, 0.0321}, {0.5, -0.0464, 0.0671}, {1.0, -0.0632, 0.0941}};
  for (const auto& [speed, time, force] : targets) {
    LumpedProblem problem = test::typical_problem("finite-sphere-hertz");
    problem.impact.speed = speed;
    problem.model.parameters = {{"stiffness", stiffness}, {"dissipation_time", 0.0}};
    const auto scalars = simulate_fast(problem).scalars;
    const ElasticImpact hertz = elastic_impact({.stiffness = stiffness, .damping = 0.0},
                                               {.mass = problem.sphere.mass, .speed = speed});
    EXPECT_NEAR(scalars.contact_time / hertz.contact_time - 1.0, time, 0.003) << speed;
    EXPECT_NEAR(scalars.peak_force / hertz.peak_force - 1.0, force, 0.003) << speed;
  }
}

TEST(FiniteSphereHertzTest, LargeSphereIsKuwabaraKono) {
  LumpedProblem finite = test::typical_problem("finite-sphere-hertz");
  finite.model.parameters["radius"] = 1e6;
  LumpedProblem plain = test::typical_problem("kuwabara-kono");
  plain.model.parameters["dissipation_time"] = finite.model.parameters.at("dissipation_time");
  const auto a = simulate_fast(finite).scalars, b = simulate_fast(plain).scalars;
  EXPECT_NEAR(a.restitution, b.restitution, 1e-4);
  EXPECT_NEAR(a.peak_force / b.peak_force, 1.0, 1e-4);
}

TEST(FiniteSphereHertzTest, RadiusComesFromTheSphere) {
  LumpedProblem problem = test::typical_problem("finite-sphere-hertz");
  problem.model.parameters.erase("radius");
  EXPECT_EQ(resolve_parameters(problem.model, problem.impact, problem.sphere).at("radius"), 0.0331);
  problem.sphere.diameter = 0.0;
  EXPECT_THROW(resolve_parameters(problem.model, problem.impact, problem.sphere), Error);
}

TEST(FiniteSphereHertzTest, GoesOnSmoothlyBeyondItsRange) {
  const FiniteSphereHertz law = law_of(radius);
  const double x = law.last_deflection, h = 1e-6 * x;
  EXPECT_GT(x, 0.2 * radius);
  EXPECT_NEAR((law.elastic_force(x + h) - law.elastic_force(x)) /
                  (law.elastic_force(x) - law.elastic_force(x - h)),
              1.0, 1e-3);
  EXPECT_NEAR((law.elastic_energy(x + h) - law.elastic_energy(x)) / (law.elastic_force(x) * h), 1.0,
              1e-4);
}

TEST(FiniteSphereHertzTest, CoefficientIsAsTabulated) {
  EXPECT_DOUBLE_EQ(finite_sphere_coefficient(0.3), 0.4114);
  EXPECT_DOUBLE_EQ(finite_sphere_coefficient(0.49), 0.3110);
  EXPECT_THROW(finite_sphere_coefficient(0.1), Error);
  EXPECT_THROW(finite_sphere_coefficient(0.5), Error);
}

}  // namespace
}  // namespace rebound
