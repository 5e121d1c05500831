// A third code beside both schemes: CalculiX with a mesh, elements (eight nodes,
// reduced integration), contact (penalty, surface to surface) and integrator of its own.
//
// Target: CalculiX, whose own error at this fineness is what the tolerances are
// made of: its penalty takes 10 µm a MPa in the impact, its step is an 80th of
// the contact, and twice the steps move the largest force by 0.14 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/modules.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/verification/calculix/calculix_run.hpp"

namespace rebound {
namespace {

constexpr calculix::Ball ball;

Material rubber() {
  return {.elastic = ElasticModel::neo_hookean_isochoric,
          .youngs_modulus = ball.youngs_modulus,
          .poisson_ratio = ball.poisson_ratio};
}

Sphere sphere() {
  return {.mass = ball.mass, .diameter = 2.0 * ball.radius};
}

class CalculixTest : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder;
};

TEST_F(CalculixTest, SlowCompression) {
  constexpr double travel = 1e-3;  // of the plane of symmetry
  constexpr int steps = 5;
  const calculix::Trace found = calculix::press(ball, travel, steps, folder.path());
  ASSERT_EQ(found.force.size(), static_cast<std::size_t>(steps));
  const CompressionProblem problem{
      .sphere = sphere(),
      .compression = {.platens = 2, .deflection = 2.0 * travel, .steps = steps},
      .material = rubber()};
  const Mesh mesh = generate_sphere_mesh(
      {.radius = ball.radius, .cells = 600, .grading = 10.0, .part = SpherePart::lower_half});
  const CompressionResult result = fem_tier().compress(problem, mesh, {});
  ASSERT_EQ(result.incomplete_because, "");
  for (int i = 1; i < steps; ++i) {
    EXPECT_NEAR(found.force[i] / result.curve.force[i + 1], 1.0, 5e-3)
        << found.time[i] << " of the travel";
    RecordProperty("calculix_" + std::to_string(i), std::to_string(found.force[i]));
    RecordProperty("nine_node_" + std::to_string(i), std::to_string(result.curve.force[i + 1]));
  }
}

struct Scalars {
  double peak_force, contact_time, restitution;
};

/// Contact time above 1 % of the largest force, restitution by impulse.
Scalars scalars_of(const calculix::Trace& trace) {
  const double peak = *std::max_element(trace.force.begin(), trace.force.end());
  double impulse = 0.0, first = -1.0, last = 0.0, time = 0.0, force = 0.0;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    const double now = trace.force[i], step = trace.time[i] - time, level = 0.01 * peak;
    impulse += 0.5 * (now + force) * step;
    const double crossing = time + step * (level - force) / (now - force);
    if (first < 0.0 && now > level) first = crossing;
    if (force > level && now <= level) last = crossing;
    time = trace.time[i];
    force = now;
  }
  return {peak, last - first, impulse / (ball.mass * trace.speed) - 1.0};
}

TEST_F(CalculixTest, ImpactAtFiveMetresPerSecond) {
  const calculix::Trace trace =
      calculix::impact(ball, {.speed = 5.0, .duration = 2.6e-3, .steps = 100}, folder.path());
  ASSERT_EQ(trace.force.size(), 100u);
  const Scalars found = scalars_of(trace);
  RecordProperty("force_calculix", std::to_string(found.peak_force));
  RecordProperty("contact_us_calculix", std::to_string(1e6 * found.contact_time));
  RecordProperty("restitution_calculix", std::to_string(found.restitution));
  for (const FemScheme scheme : {FemScheme::explicit_steps, FemScheme::implicit_steps}) {
    FemProblem problem{.scheme = scheme, .sphere = sphere(), .material = rubber()};
    problem.impact.speed = trace.speed;
    const bool implicit = scheme == FemScheme::implicit_steps;
    const FemResult result = fem_tier().simulate(
        problem, generate_sphere_mesh({.radius = ball.radius, .cells = implicit ? 250 : 2000}), {});
    ASSERT_EQ(result.incomplete_because, "");
    const char* name = implicit ? "implicit" : "explicit";
    EXPECT_NEAR(found.peak_force / result.scalars.peak_force, 1.0, 0.01) << name;
    EXPECT_NEAR(found.contact_time / result.scalars.contact_time_1pct, 1.0, 0.01) << name;
    EXPECT_NEAR(found.restitution, result.restitution_momentum, 2e-3) << name;
    RecordProperty(std::string("force_") + name, std::to_string(result.scalars.peak_force));
    RecordProperty(std::string("contact_us_") + name,
                   std::to_string(1e6 * result.scalars.contact_time_1pct));
    RecordProperty(std::string("restitution_") + name, std::to_string(result.restitution_momentum));
  }
}

}  // namespace
}  // namespace rebound
