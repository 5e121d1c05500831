#include <gtest/gtest.h>

#include <string>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/elastic_models.hpp"
#include "tests/support/effect_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

/// What more than one number must satisfy: the reader's refusal is the solver's, with a line.
struct TogetherCase {
  const char* name;
  const char* key;
  void (*change)(FemProblem&);
};

class TogetherTest : public ::testing::TestWithParam<TogetherCase> {};

TEST_P(TogetherTest, ReaderAndSolverRefuseAlike) {
  FemProblem problem = test::fem_problem_for_effects();
  GetParam().change(problem);
  const std::string text = write_toml(FemImpactFile{.problem = problem, .effects = {}});
  const Error solving = refusal_of([&] { check(problem); });
  const Error reading = refusal_of([&] { read_fem_impact(Document::parse(text, "f.toml")); });
  EXPECT_EQ(solving.code(), ExitCode::bad_input);
  EXPECT_EQ(solving.location().key, GetParam().key);
  EXPECT_EQ(reading.location().key, GetParam().key);
  EXPECT_EQ(reading.location().allowed, solving.location().allowed);
  EXPECT_STREQ(reading.what(), solving.what());
  EXPECT_EQ(reading.location().file, "f.toml");
  EXPECT_GT(reading.location().line, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, TogetherTest,
    ::testing::Values(
        TogetherCase{"Shares", "model.material.branch[1].ratio",
                     [](FemProblem& p) {
                       p.material.branches = {{.ratio = 0.6, .relaxation_time = 1e-3},
                                              {.ratio = 0.4, .relaxation_time = 1e-4}};
                     }},
        TogetherCase{"Layers", "model.material.layer[1].from",
                     [](FemProblem& p) {
                       p.material.layers = {{.from = 0.8, .modulus_factor = 2.0},
                                            {.from = 0.8, .modulus_factor = 3.0}};
                     }},
        TogetherCase{"StrainFactors", "model.material.branch[0].relaxes",
                     [](FemProblem& p) {
                       p.material.strain.mullins = 0.1;
                       p.material.branches[0].relaxes = Relaxes::deviator;
                     }},
        TogetherCase{"TooManyTerms", "model.material.term",
                     [](FemProblem& p) {
                       p.material.elastic = ElasticModel::ogden;
                       p.material.terms.resize(most_stretch_terms + 1);
                     }},
        TogetherCase{"Exponent", "model.material.term[0].exponent",
                     [](FemProblem& p) {
                       p.material.elastic = ElasticModel::ogden;
                       p.material.terms = {{.exponent = 0.0}};
                     }},
        TogetherCase{"SomeBetas", "model.material.term[0]",
                     [](FemProblem& p) {
                       p.material.elastic = ElasticModel::hyperfoam;
                       p.material.terms = {{.beta = 2.0}, {.exponent = 4.0}};
                     }},
        TogetherCase{"OtherPoissonRatio", "model.material.poisson_ratio",
                     [](FemProblem& p) {
                       p.material.elastic = ElasticModel::hyperfoam;
                       p.material.terms = {{.beta = 1.0}};
                     }},
        TogetherCase{
            "AdhesionRange", "model.adhesion.range",
            [](FemProblem& p) { p.adhesion = {.work = 1.0, .range = 0.3 * p.sphere.radius()}; }},
        TogetherCase{"AdhesionWork", "model.adhesion.work",
                     [](FemProblem& p) { p.adhesion = {.work = 9e4, .range = 1e-3}; }},
        TogetherCase{"OutputInterval", "controls.output_interval",
                     [](FemProblem& p) { p.controls.output_interval = 1e-12; }},
        TogetherCase{"Separation", "impact.separation",
                     [](FemProblem& p) { p.impact.separation = SeparationRule::zero_deflection; }},
        TogetherCase{"ImplicitAdhesionToAMovingPlate", "model.adhesion.work",
                     [](FemProblem& p) {
                       p.scheme = FemScheme::implicit_steps;
                       p.plate.stiffness = 5e7;
                       p.adhesion.work = 1.0;
                     }},
        TogetherCase{"ImplicitLayers", "model.scheme",
                     [](FemProblem& p) {
                       p.scheme = FemScheme::implicit_steps;
                       p.material.layers = {{.from = 0.8, .modulus_factor = 2.0}};
                     }}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rebound
