// Case c: static contact, sphere on a rigid plate and between two platens.
//
// Target: x = x_Hertz (1 − s) with s of the finite sphere, linear elasticity. Two
// computations of it differ at a/R = 0.1 by 0.002: where the load is normal to the sphere,
// or to the plate, which linear theory leaves open at the order of s itself. The neo-Hookean
// law lies below by 0.002 at 0.1 and 0.008 at 0.2; other laws elsewhere (see the last but
// one test). 400 and 3200 cells differ by less than 0.001 in s.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "comparisons/inference/calibration/platen_modulus.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "fem/implicit/static_compression.hpp"
#include "fem/interface/elastic_models.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331, modulus = 10e6, nu = 0.4;
constexpr double hertz_modulus = modulus / (1.0 - nu * nu);

Material neo_hookean() {
  return {.youngs_modulus = modulus, .poisson_ratio = nu};
}

CompressionProblem problem_of(int platens, double deflection, int steps) {
  CompressionProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 2.0 * radius};
  problem.material = neo_hookean();
  problem.compression = {.platens = platens, .deflection = deflection, .steps = steps};
  return problem;
}

/// Cells as small in the contact as it needs them.
double grading_for(double contact) {
  return std::clamp(0.3 / (contact * contact), 1.0, 200.0);
}

CompressionResult compress(const CompressionProblem& problem, double contact, int cells) {
  const Mesh mesh = generate_sphere_mesh(
      {.radius = radius,
       .cells = cells,
       .grading = grading_for(contact),
       .part = problem.compression.platens == 2 ? SpherePart::lower_half : SpherePart::whole});
  CompressionResult result = fem::run_static_compression(mesh, problem, {});
  EXPECT_EQ(result.incomplete_because, "");
  return result;
}

/// s = 1 − x/x_Hertz at the force found, per contact.
double correction(int platens, double a, double s_expected, int cells,
                  const Material& material = neo_hookean()) {
  const double approach = a * a * radius * (1.0 - s_expected);
  auto problem = problem_of(platens, approach * platens, 4);
  problem.material = material;
  const auto result = compress(problem, a, cells);
  const double force = result.curve.force.back();
  const double hertz = std::pow(0.75 * force / (hertz_modulus * std::sqrt(radius)), 2.0 / 3.0);
  return 1.0 - approach / hertz;
}

TEST(VerificationCaseC, FiniteSphereCorrection) {
  for (const auto& target : targets::static_contacts) {
    const double s = correction(target.platens, target.a_over_r, target.s, 400);
    EXPECT_NEAR(s, target.s, target.tolerance) << target.platens << " " << target.a_over_r;
  }
}

// The same cells and the same contact with the tangent at rest; rows of `rebound verify`.
TEST(VerificationCaseC, LinearKinematicsAgreeWithASmallStrainComputation) {
  test::expect_rows(verify_linear_contact(fem::element_checks()).rows, 4);
}

// The correction is of first order in a/R, and so are the strains: laws with the same
// moduli at rest differ in it as much as it is large. What all share is Hertz.
TEST(VerificationCaseC, TheCorrectionBelongsToTheLawAndHertzToAll) {
  for (const double exponent : {-8.0, 8.0}) {
    Material law{.elastic = ElasticModel::hyperfoam,
                 .youngs_modulus = modulus,
                 .poisson_ratio = nu,
                 .terms = {{1.0, exponent, {}}}};
    const double small = correction(1, 0.05, 0.0285, 800, law),
                 large = correction(1, 0.1, 0.057, 800, law);
    EXPECT_NEAR(large / small, 2.0, 0.06) << exponent;
    EXPECT_GT(std::abs(large - 0.0569), 0.01) << exponent;
  }
}

// s is proportional to a/R: half of it at half the contact.
TEST(VerificationCaseC, HertzIsTheLimitOfSmallContacts) {
  EXPECT_NEAR(correction(1, 0.05, 0.02755, 800), 0.02755, 1.5e-3);
  EXPECT_NEAR(correction(2, 0.05, 0.01392, 800), 0.01392, 1.5e-3);
}

TEST(VerificationCaseC, WorkIsStored) {
  for (const int platens : {1, 2}) {
    const auto curve = compress(problem_of(platens, 4e-3 * platens, 40), 0.5, 100).curve;
    EXPECT_NEAR(curve.work.back() / curve.stored.back(), 1.0, 1e-3) << platens;
    for (std::size_t i = 1; i < curve.force.size(); ++i)
      EXPECT_GT(curve.force[i], curve.force[i - 1]);
  }
}

// 16 mm of a 66 mm core; the linear route from a platen law to the modulus, which
// the calibration of the cores takes from 0.5 to 2.5 mm, finds what was put in.
TEST(VerificationCaseC, SixteenMillimetresBetweenPlatens) {
  const auto curve = compress(problem_of(2, 16e-3, 64), 0.55, 250).curve;
  ASSERT_EQ(curve.deflection.size(), 65u);
  EXPECT_NEAR(curve.deflection.back(), 16e-3, 1e-15);
  for (const auto& [from, to] : {std::pair{0.0, 16e-3}, {0.5e-3, 2.5e-3}}) {
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < curve.force.size(); ++i) {
      if (curve.deflection[i] < from || curve.deflection[i] > 1.0001 * to) continue;
      const double power = std::pow(curve.deflection[i], 1.5);
      product += curve.force[i] * power;
      square += power * power;
    }
    const double found = modulus_from_platens({.stiffness = product / square,
                                               .diameter = 2.0 * radius,
                                               .poisson_ratio = nu,
                                               .shortest_travel = from,
                                               .longest_travel = to});
    EXPECT_NEAR(found / modulus, 1.0, 0.015) << to;
    RecordProperty("modulus_ratio_to_" + std::to_string(1e3 * to) + "mm",
                   std::to_string(found / modulus));
  }
}

TEST(VerificationCaseC, RefusesAndStops) {
  const Mesh whole = generate_sphere_mesh({.radius = radius, .cells = 60});
  const auto refused = [&](auto change) {
    CompressionProblem problem = problem_of(1, 1e-3, 4);
    change(problem);
    try {
      fem::run_static_compression(whole, problem, {});
    } catch (const Error& error) {
      return error.location().key;
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused([](auto& p) { p.compression.deflection = 1.0; }), "compression.deflection");
  EXPECT_EQ(refused([](auto& p) { p.compression.platens = 3; }), "compression.platens");
  EXPECT_EQ(refused([](auto& p) { p.compression.steps = 0; }), "compression.steps");
  EXPECT_EQ(refused([](auto& p) { p.compression.path = CompressionPath::triangle; }),
            "compression.path");
  EXPECT_EQ(refused([](auto& p) { p.compression.platens = 2; }), "");  // half a sphere is needed
  int asked = 0;
  const auto stopped = fem::run_static_compression(
      whole, problem_of(1, 1e-3, 4), {.interrupted = [&] { return ++asked == 3; }, .progress = {}});
  EXPECT_EQ(stopped.incomplete_because, "interrupted");
  EXPECT_EQ(stopped.curve.force.size(), 3u);
}

}  // namespace
}  // namespace rebound
