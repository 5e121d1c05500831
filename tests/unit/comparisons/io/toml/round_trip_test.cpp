#include <gtest/gtest.h>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "fem/interface/elastic_models.hpp"
#include "lumped/laws/laws.hpp"

namespace rebound {
namespace {

FemProblem every_fem_member_set() {
  FemProblem problem;
  problem.sphere = {.mass = 0.1 / 1.1, .diameter = 0.2 / 3.1};
  problem.impact = {.speed = 17.0 / 3.0};
  problem.material = {
      .elastic = ElasticModel::neo_hookean_isochoric,
      .youngs_modulus = 1e7 / 3.0,
      .poisson_ratio = 1.0 / 3.0,
      .modulus = ModulusBasis::long_term,
      .branches = {{.ratio = 2.0 / 3.0, .relaxation_time = 1e-3 / 7.0},
                   {.ratio = 0.1, .relaxation_time = 1e-4, .relaxes = Relaxes::deviator}}};
  problem.cells = 777;
  problem.controls = {.step_safety = 0.7,
                      .output_interval = 1e-6 / 3.0,
                      .end_time = 0.01 / 3.0,
                      .field_frames = 12,
                      .field_directory = ""};
  return problem;
}

/// Writing what was read gives the same text: every member survived.
TEST(RoundTripTest, FemProblemKeepsEveryBit) {
  for (const Comments comments : {Comments::none, Comments::sentences}) {
    const FemProblem problem = every_fem_member_set();
    const std::string text = write_toml(problem, comments);
    const FemProblem read = read_fem_problem(Document::parse(text, "f"));
    EXPECT_EQ(read.sphere.mass, problem.sphere.mass);
    EXPECT_EQ(read.sphere.diameter, problem.sphere.diameter);
    EXPECT_EQ(read.impact.speed, problem.impact.speed);
    EXPECT_EQ(read.material.elastic, problem.material.elastic);
    EXPECT_EQ(read.material.youngs_modulus, problem.material.youngs_modulus);
    EXPECT_EQ(read.material.poisson_ratio, problem.material.poisson_ratio);
    EXPECT_EQ(read.material.modulus, problem.material.modulus);
    ASSERT_EQ(read.material.branches.size(), 2u);
    EXPECT_EQ(read.material.branches[0].ratio, problem.material.branches[0].ratio);
    EXPECT_EQ(read.material.branches[1].relaxes, Relaxes::deviator);
    EXPECT_EQ(read.cells, 777);
    EXPECT_EQ(read.controls.step_safety, 0.7);
    EXPECT_EQ(read.controls.output_interval, problem.controls.output_interval);
    EXPECT_EQ(read.controls.end_time, problem.controls.end_time);
    EXPECT_EQ(read.controls.field_frames, 12);
    EXPECT_EQ(write_toml(read, comments), text);
  }
}

/// The keys of each elastic law survive writing and reading.
TEST(RoundTripTest, EveryElasticLawKeepsEveryBit) {
  std::vector<Material> materials(4, every_fem_member_set().material);
  materials[0].elastic = ElasticModel::mooney_rivlin;
  materials[0].second_share = 1.0 / 7.0;
  materials[1].elastic = ElasticModel::ogden;
  materials[1].terms = {{.weight = 1.0 / 3.0, .exponent = 4.0 / 3.0},
                        {.weight = 0.2, .exponent = -2.0}};
  materials[2].elastic = ElasticModel::hyperfoam;
  materials[2].terms = {{.weight = 1.0 / 3.0, .exponent = 4.0 / 3.0}};
  materials[3] = materials[2];
  materials[3].terms.push_back({.weight = 1.0 / 3.0, .exponent = -7.0, .beta = 1.1});
  materials[3].terms[0].beta = 0.9;
  materials.push_back(materials[0]);
  materials[4].branches = {{.ratio = 0.1,
                            .relaxation_time = 1e-3 / 3.0,
                            .rate_exponent = 1.0 / 7.0,
                            .reference_strain = 0.03 / 7.0}};
  materials[4].relaxation = Relaxation::multiplicative;
  materials[4].retardation_time = 1e-5 / 3.0;
  materials[4].strain = {.stiffening = 1.0 / 3.0,
                         .softening = 0.1 / 3.0,
                         .densification = 7.0 / 3.0,
                         .mullins = 0.2 / 3.0};
  materials[4].layers = {{.from = 0.5 / 3.0, .modulus_factor = 4.0 / 3.0},
                         {.from = 0.8, .modulus_factor = 0.5}};
  for (const Material& material : materials) {
    FemProblem problem = every_fem_member_set();
    problem.material = material;
    const std::string text = write_toml(problem);
    SCOPED_TRACE(text);
    EXPECT_EQ(read_fem_problem(Document::parse(text, "f")).material, material);
  }
}

TEST(RoundTripTest, TheImplicitSchemeStays) {
  FemProblem problem = every_fem_member_set();
  problem.scheme = FemScheme::implicit_steps;
  const std::string text = write_toml(problem);
  const FemProblem read = read_fem_problem(Document::parse(text, "f"));
  EXPECT_EQ(read.scheme, FemScheme::implicit_steps);
  EXPECT_EQ(write_toml(read), text);
}

TEST(RoundTripTest, EveryLawKeepsEveryBit) {
  for (const LawCard& law : all_laws()) {
    LumpedProblem problem;
    problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
    problem.impact = {.speed = 15.0, .separation = SeparationRule::zero_deflection};
    problem.model.law = law.name;
    ParametersAtSpeed at{.speed = 5.0, .parameters = {}};
    for (const ParameterCard& card : law.parameters) {
      problem.model.parameters[card.name] = card.default_value.value_or(1.0 + 1.0 / 3.0);
      at.parameters[card.name] = card.default_value.value_or(1.0 + 1.0 / 7.0);
    }
    problem.model.at_speed = {at};
    const std::string text = write_toml(problem);
    SCOPED_TRACE(text);
    const LumpedProblem read = read_lumped_problem(Document::parse(text, "f"));
    EXPECT_EQ(read.model.law, law.name);
    EXPECT_EQ(read.model.parameters, problem.model.parameters);
    ASSERT_EQ(read.model.at_speed.size(), 1u);
    EXPECT_EQ(read.model.at_speed[0].parameters, at.parameters);
    EXPECT_EQ(read.impact.separation, SeparationRule::zero_deflection);
    EXPECT_EQ(write_toml(read), text);
  }
}

}  // namespace
}  // namespace rebound
