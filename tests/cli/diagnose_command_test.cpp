// `synthesize` and `diagnose` as a laboratory would use them, end to end.
#include <fstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

const std::string experiment = R"(schema = 1
name = "hidden"
seed = 5
[sphere]
mass = "89.6 g"
mass_uncertainty = "0.1 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.2e6 N/m^1.5"
damping = "7e4 N.s/m^2.5"
[[model.effect]]
name = "hysteresis"
size = 0.25
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
[[shot]]
speed = "5 m/s"
speed_uncertainty = "0.02 m/s"
[[shot]]
speed = "15 m/s"
speed_uncertainty = "0.05 m/s"
[[shot]]
speed = "25 m/s"
speed_uncertainty = "0.1 m/s"
)";

const std::string believed = R"(schema = 1
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "8e4 N.s/m^2.5"
)";

class DiagnoseCommand : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("experiment.toml", experiment);
    folder.write("believed.toml", believed);
  }
  nlohmann::json json_of(const Outcome& outcome) const {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  }
};

TEST_F(DiagnoseCommand, FindsWhatIsHiddenAndItsModelRuns) {
  const auto made = json_of(rebound({"synthesize", "experiment.toml", "--out", "x", "--json"}));
  EXPECT_EQ(made["shots"], 3);
  EXPECT_TRUE(there("x/truth.json"));
  const auto found =
      json_of(rebound({"diagnose", "x/data", "--model", "believed.toml", "--out", "d", "--json"}));
  EXPECT_EQ(found["schema"], 1);
  EXPECT_EQ(found["verdict"], "missing");
  EXPECT_EQ(found["effects"][0]["name"], "hysteresis");
  EXPECT_EQ(found["effects"][0]["unit"], "1");
  EXPECT_EQ(found["effects"][0]["tiers"]["lumped"], "supported");
  // FE follows these data of a lumped law neither way: it has waves, and they have none.
  EXPECT_EQ(found["effects"][0]["tiers"]["fem"], FEM_TIER_IS_BUILT ? "no-fit" : "not-run");
  EXPECT_EQ(found["candidates"][0][0], "hysteresis");
  EXPECT_GT(found["gap"]["held_out_before"].get<double>(),
            found["gap"]["held_out_after"].get<double>());
  EXPECT_EQ(found["held_out_speed_m_s"], 15.0);
  EXPECT_EQ(found["seed"], 1);
  const std::string extended = found["extended_model"];
  EXPECT_EQ(rebound({"lumped", extended}).exit_code, 0);
  EXPECT_EQ(rebound({"synthesize", extended, "--out", "again"}).exit_code, 0);
  const auto closed =
      json_of(rebound({"diagnose", "x/data", "--model", extended, "--out", "d2", "--json"}));
  EXPECT_EQ(closed["verdict"], "agrees");
  EXPECT_TRUE(closed["extended_model"].is_null());
  EXPECT_FALSE(closed["excluded_above"].empty());
  EXPECT_TRUE(there("d/report.html"));
  EXPECT_TRUE(there("d/diagnosis.json"));
}

TEST_F(DiagnoseCommand, TheLawAnswersAloneWhereFiniteElementsAreNotAsked) {
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  const auto found =
      json_of(rebound({"diagnose", "x/data", "--model", "believed.toml", "--no-fem", "--json"}));
  EXPECT_EQ(found["verdict"], "missing");
  EXPECT_EQ(found["effects"][0]["name"], "hysteresis");
  EXPECT_EQ(found["effects"][0]["tiers"]["fem"], "not-run");
  EXPECT_TRUE(found["in_fem"].empty());
  EXPECT_NE(found["warnings"].dump().find("--no-fem"), std::string::npos) << "said on the page";
}

TEST_F(DiagnoseCommand, AGapFailsOnRequest) {
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  EXPECT_EQ(rebound({"diagnose", "x/data", "--model", "believed.toml", "--no-fem", "--fail-on-gap"})
                .exit_code,
            1);
  EXPECT_TRUE(there("results/diagnosis-data/report.html"));
}

TEST_F(DiagnoseCommand, ASealedTruthIsNowhereNearTheData) {
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x", "--seal", "--truth",
                     "elsewhere.json"})
                .exit_code,
            0);
  EXPECT_FALSE(there("x/truth.json"));
  EXPECT_TRUE(there("x/seal.json"));
  EXPECT_TRUE(there("elsewhere.json"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "x")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text.find("hysteresis"), std::string::npos) << entry.path();
  }
  EXPECT_EQ(rebound({"synthesize", "experiment.toml", "--out", "y", "--seal"}).exit_code, 2);
  EXPECT_EQ(rebound({"synthesize", "experiment.toml"}).exit_code, 2);
}

TEST_F(DiagnoseCommand, TheSameSeedGivesTheSameData) {
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "y"}).exit_code, 0);
  const auto text = [&](const char* file) {
    std::ifstream stream(folder.path() / file);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  EXPECT_EQ(text("x/data/shot-01.csv"), text("y/data/shot-01.csv"));
}

TEST_F(DiagnoseCommand, BadInputIsRefusedWithItsPlace) {
  ASSERT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
  const auto refused = [&](const std::string& text, const std::string& part) {
    folder.write("bad.toml", text);
    const Outcome outcome = rebound({"diagnose", "x/data", "--model", "bad.toml"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  refused(believed + "[sphere]\nmass = \"45 g\"\ndiameter = \"66.2 mm\"\n", "sphere.mass");
  refused(replaced(believed, "lumped", "fem"), "model.law");
  refused(replaced(believed, "stiffness", "stifness"), "stifness");
  EXPECT_EQ(
      rebound({"diagnose", "x/data", "--model", "believed.toml", "--hold-out", "7 m/s"}).exit_code,
      2);
  EXPECT_EQ(
      rebound({"diagnose", "x/data", "--model", "believed.toml", "--hold-out", "15"}).exit_code, 2);
  EXPECT_EQ(rebound({"diagnose", "nowhere", "--model", "believed.toml"}).exit_code, 4);
}

}  // namespace
}  // namespace rebound::testing
