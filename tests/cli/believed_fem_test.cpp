// `diagnose` with an FE model in doubt: data of the FE tier on a mesh of its own, end to end.
#include "tests/cli/diagnosed_experiment.hpp"

namespace rebound::testing {
namespace {

/// The mesh is much finer than any that a diagnosis runs on, so that the data have no ripple of
/// nodes that touch one by one, as no real ball has.
const std::string experiment = R"(schema = 1
name = "hidden"
seed = 1
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 12000
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
[[model.effect]]
name = "relaxation"
size = 0.5
relaxation_time = "0.3 ms"
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
[sampling]
rate = "200 kHz"
before = "0.2 ms"
after = "0.5 ms"
[[shot]]
speed = "5 m/s"
speed_uncertainty = "0.02 m/s"
[[shot]]
speed = "15 m/s"
speed_uncertainty = "0.06 m/s"
[[shot]]
speed = "25 m/s"
speed_uncertainty = "0.1 m/s"
)";

const std::string elastic = R"(schema = 1
[model]
tier = "fem"
[model.material]
elastic = "neo-hookean"
youngs_modulus = "12 MPa"
poisson_ratio = 0.4
)";

const std::string relaxation = R"([[model.effect]]
name = "relaxation"
size = 0.3
relaxation_time = "0.5 ms"
)";

class BelievedFem : public DiagnosedExperiment {};

TEST_F(BelievedFem, ABranchThatIsMissingIsNamed) {
  const auto found = diagnosis_of(experiment, elastic);
  ASSERT_EQ(found["verdict"], "missing") << found["warnings"];
  ASSERT_EQ(found["effects"].size(), 1u);
  EXPECT_EQ(found["effects"][0]["name"], "relaxation");
  EXPECT_EQ(found["effects"][0]["tiers"]["fem"], "supported");
  EXPECT_NEAR(found["effects"][0]["size"].get<double>(), 0.5, 0.1);
  EXPECT_EQ(found["believed_tier"], "fem");
  EXPECT_LT(found["numerical_uncertainty"].get<double>(), 0.01);
  EXPECT_GT(found["gap"]["before"].get<double>(), 1.5);
  EXPECT_LT(found["gap"]["after"].get<double>(), 1.2);
  EXPECT_GT(found["gap"]["held_out_before"].get<double>(), 1.4);
  EXPECT_LT(found["gap"]["held_out_after"].get<double>(), 1.2);

  const Outcome again = rebound({"fem", "diagnosis/extended.toml", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_GT(nlohmann::json::parse(again.output)["restitution"].get<double>(), 0.5);
}

TEST_F(BelievedFem, AModelOfTheSameFormAgrees) {
  const auto found = diagnosis_of(experiment, elastic + relaxation);
  EXPECT_EQ(found["verdict"], "agrees") << found["warnings"];
  EXPECT_TRUE(found["effects"].empty());
  EXPECT_LT(found["gap"]["before"].get<double>(), 1.2);
  EXPECT_FALSE(found["excluded_above"].empty());
}

TEST_F(BelievedFem, TheImplicitSchemeIsRefused) {
  folder.write("experiment.toml", experiment);
  folder.write("believed.toml",
               replaced(elastic, "tier = \"fem\"", "tier = \"fem\"\nscheme = \"implicit\""));
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  const Outcome outcome = rebound({"diagnose", "x/data", "--model", "believed.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("model.scheme"), std::string::npos) << outcome.errors;
}

TEST_F(BelievedFem, IsNotDiagnosedWithoutFiniteElements) {
  folder.write("experiment.toml", experiment);
  folder.write("believed.toml", elastic);
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  const Outcome outcome = rebound({"diagnose", "x/data", "--model", "believed.toml", "--no-fem"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("--no-fem"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
