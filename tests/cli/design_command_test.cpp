// `design` as a laboratory meets it before a test.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class DesignCommand : public ProgramTest {
 protected:
  const std::string plan = R"(schema = 1
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
[[shot]]
speed = "5 m/s"
[[shot]]
speed = "15 m/s"
)";
};

TEST_F(DesignCommand, SaysWhatWouldBeFound) {
  folder.write("plan.toml", plan);
  const auto outcome = rebound({"design", "plan.toml", "--json", "--out", "design"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["shots"], 2);
  EXPECT_GT(json["effects"].size(), 10u);
  EXPECT_GT(json["changes"].size(), 3u);
  EXPECT_TRUE(there("design/report.html"));
  EXPECT_TRUE(there("design/design.json"));
  EXPECT_NE(rebound({"design", "plan.toml"}).output.find("found from"), std::string::npos);
}

TEST_F(DesignCommand, AnEffectAloneNeedsExperiments) {
  folder.write("plan.toml", plan);
  const auto outcome = rebound({"design", "plan.toml", "--effect", "relaxation", "--json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["error"]["key"], "--effect");
}

TEST_F(DesignCommand, CountsWhatItPredicts) {
  folder.write("plan.toml", plan);
  const auto outcome = rebound(
      {"design", "plan.toml", "--experiments", "2", "--effect", "strain-stiffening", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto rows = nlohmann::json::parse(outcome.output)["experiments"];
  ASSERT_EQ(rows.size(), 4u);  // nothing, and three sizes
  EXPECT_TRUE(rows[0]["effect"].is_null());
  EXPECT_EQ(rows[3]["experiments"], 2);
  EXPECT_LE(rows[3]["gap_counted"]["low"], rows[3]["gap_counted"]["value"]);
}

TEST_F(DesignCommand, ThreadsChangeNothing) {
  folder.write("plan.toml", plan.substr(0, plan.rfind("[[shot]]")));
  EXPECT_EQ(rebound({"design", "plan.toml", "--json", "--threads", "1"}).output,
            rebound({"design", "plan.toml", "--json", "--threads", "2"}).output);
}

TEST_F(DesignCommand, APlanWithSomethingHiddenIsRefusedWithItsPlace) {
  folder.write("plan.toml", plan + "[[model.effect]]\nname = \"strain-stiffening\"\nsize = 0.3\n");
  const auto outcome = rebound({"design", "plan.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 2);
  const auto error = nlohmann::json::parse(outcome.output)["error"];
  EXPECT_EQ(error["key"], "model.effect");
  EXPECT_EQ(error["allowed"], "no effect");
  EXPECT_FALSE(error["line"].is_null());
}

}  // namespace
}  // namespace rebound::testing
