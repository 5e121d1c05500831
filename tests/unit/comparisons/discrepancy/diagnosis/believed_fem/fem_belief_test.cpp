// Impacts of a believed FE model: what they are kept by, and what their histories are counted by.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

Observations one_shot() {
  Observations all;
  all.balls = {{.name = "ball", .sphere = {.mass = 0.0896, .diameter = 0.0662}}};
  MeasuredImpact shot;
  shot.sphere = all.balls.front().sphere;
  shot.impact.speed = 10.0;
  all.shots = {shot};
  return all;
}

Material of_one_branch() {
  Material material{.youngs_modulus = 10e6,
                    .poisson_ratio = 0.4,
                    .modulus = ModulusBasis::long_term,
                    .branches = {}};
  material.branches = {{.ratio = 1.0, .relaxation_time = 4e-5}};
  return material;
}

/// A branch of the same numbers that relaxes something else is another impact.
TEST(KeptImpacts, AreOfOneKindOfBranch) {
  const Material all_stress = of_one_branch();
  const FemBelief fem({}, one_shot(), {all_stress}, 100, {});
  const double restitution = fem.run(0, {.speed = 10.0}, all_stress, {}).scalars.restitution;
  Material other = all_stress;
  other.branches.front().relaxes = Relaxes::deviator;
  EXPECT_GT(fem.run(0, {.speed = 10.0}, other, {}).scalars.restitution, restitution + 0.002)
      << "a bulk that does not relax loses nothing";
  other = all_stress;
  other.relaxation = Relaxation::multiplicative;
  other.branches.front().rate_exponent = 0.5;
  EXPECT_NE(fem.run(0, {.speed = 10.0}, other, {}).scalars.restitution, restitution);
  EXPECT_EQ(fem.run(0, {.speed = 10.0}, all_stress, {}).scalars.restitution, restitution);
}

TEST(KeptImpacts, AreOfOneElasticLaw) {
  const Material neo_hookean = of_one_branch();
  const FemBelief fem({}, one_shot(), {neo_hookean}, 100, {});
  const auto peak_of = [&](const Material& material) {
    return fem.run(0, {.speed = 10.0}, material, {}).scalars.peak_force;
  };
  const double peak = peak_of(neo_hookean);
  Material other = neo_hookean;
  other.elastic = ElasticModel::hyperfoam;
  other.terms = {{.exponent = 4.0, .beta = {}}};
  const double of_foam = peak_of(other);
  EXPECT_GT(std::abs(of_foam - peak), 1e-3 * peak);
  other.elastic = ElasticModel::ogden;
  EXPECT_GT(std::abs(peak_of(other) - of_foam), 1e-3 * peak) << "of the same terms";
  other.elastic = ElasticModel::hyperfoam;
  other.terms.front().exponent = 6.0;
  EXPECT_NE(peak_of(other), of_foam);
  other = neo_hookean;
  other.elastic = ElasticModel::mooney_rivlin;
  const double of_no_share = peak_of(other);
  other.second_share = 0.5;
  EXPECT_NE(peak_of(other), of_no_share);
  EXPECT_EQ(peak_of(neo_hookean), peak);
}

/// The last node leaves when it likes: contact times jump by a quarter of a per cent from one size
/// of an effect to the next. What histories are counted by does not.
TEST(SpanOfAnImpact, ChangesSmoothlyWithTheMaterial) {
  const Material material = of_one_branch();
  const FemBelief fem({}, one_shot(), {material}, 300, {});
  std::vector<double> spans;
  for (int k = 0; k < 8; ++k) {
    const EffectChoice softening{
        .name = "foam-softening", .size = 0.01 + 0.01 * k, .parameters = {}};
    const ModelledImpact impact = fem.run(0, {.speed = 20.0}, material, {softening});
    spans.push_back(impact.trace.time.back());
    EXPECT_GE(impact.trace.time.back(), impact.scalars.contact_time);
    EXPECT_NEAR(impact.trace.force.back(), 0.0, 1e-6 * impact.scalars.peak_force);
  }
  for (std::size_t k = 1; k + 1 < spans.size(); ++k)
    EXPECT_LT(std::abs(spans[k + 1] - 2.0 * spans[k] + spans[k - 1]), 5e-4 * spans[k]) << k;
}

/// A pull is followed to its end, and a push without one is not.
TEST(SpanOfAnImpact, IsTheWholeTraceUnderAPull) {
  const Material material = of_one_branch();
  const FemBelief fem({}, one_shot(), {material}, 300, {});
  const EffectChoice pull{
      .name = "adhesion", .size = 500.0, .parameters = {{"range_over_radius", 0.055}}};
  const ModelledImpact sticks = fem.run(0, {.speed = 10.0}, material, {pull});
  EXPECT_GT(sticks.trace.time.back(), 1.1 * sticks.scalars.contact_time_1pct);
  EXPECT_LT(*std::min_element(sticks.trace.force.begin(), sticks.trace.force.end()), 0.0);
  const ModelledImpact leaves = fem.run(0, {.speed = 10.0}, material, {});
  EXPECT_DOUBLE_EQ(leaves.trace.time.back() - leaves.trace.time.front(),
                   1.1 * leaves.scalars.contact_time_1pct);
}

}  // namespace
}  // namespace rebound
