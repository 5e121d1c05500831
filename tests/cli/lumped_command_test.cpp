#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class LumpedCommandTest : public ProgramTest {};

TEST_F(LumpedCommandTest, PrintsTheContractsKeysAndNothingElse) {
  folder.write("a.toml", lumped_file);
  const Outcome outcome = rebound({"lumped", "a.toml", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["separation_rule"], "zero-force");
  for (const char* key :
       {"restitution", "contact_time_s", "contact_time_1pct_s", "peak_force_N", "peak_deflection_m",
        "mean_deflection_m", "rebound_speed_m_s", "impulse_closure", "energy_closure", "wall_s"})
    EXPECT_TRUE(json[key].is_number()) << key;
  // The paper's damping, integrated, returns 0.66 and not the measured 0.527.
  EXPECT_NEAR(json["restitution"].get<double>(), 0.661, 0.001);
}

TEST_F(LumpedCommandTest, TheEffectiveConfigurationGivesTheSameTraceBitForBit) {
  folder.write("a.toml", lumped_file);
  ASSERT_EQ(rebound({"lumped", "a.toml", "--out", "one"}).exit_code, 0);
  ASSERT_EQ(rebound({"lumped", "one/effective.toml", "--out", "two"}).exit_code, 0);
  const std::string trace = read_whole(folder.path() / "one/trace.csv");
  EXPECT_TRUE(trace.starts_with("time_s,force_N,deflection_m\n"));
  EXPECT_EQ(trace, read_whole(folder.path() / "two/trace.csv"));
  const auto json = nlohmann::json::parse(read_whole(folder.path() / "one/result.json"));
  EXPECT_EQ(json["provenance"]["input"], "a.toml");
  EXPECT_EQ(json["provenance"]["input_sha256"].get<std::string>().size(), 64u);
}

TEST_F(LumpedCommandTest, EffectsStayEffectsInTheEffectiveConfiguration) {
  folder.write("a.toml", lumped_file + R"([[model.effect]]
name = "permanent-set"
size = 0.05
[[model.effect]]
name = "plate-compliance"
size = "0.02 um/N"
)");
  ASSERT_EQ(rebound({"lumped", "a.toml", "--out", "one"}).exit_code, 0);
  ASSERT_EQ(rebound({"lumped", "one/effective.toml", "--out", "two"}).exit_code, 0);
  const std::string effective = read_whole(folder.path() / "one/effective.toml");
  EXPECT_NE(effective.find("[[model.effect]]\nname = \"permanent-set\"\nsize = 0.05\n"),
            std::string::npos);
  EXPECT_EQ(effective.find("[model.plate]"), std::string::npos);
  const std::string trace = read_whole(folder.path() / "one/trace.csv");
  EXPECT_TRUE(
      trace.starts_with("time_s,force_N,deflection_m,contact_force_N,plate_displacement_m\n"));
  EXPECT_EQ(trace, read_whole(folder.path() / "two/trace.csv"));
}

// A model that a diagnosis has extended by one is taken as it stands.
TEST_F(LumpedCommandTest, AFaultOfTheMeasurementIsNamedAndLeftOut) {
  folder.write("a.toml",
               lumped_file + "[[model.effect]]\nname = \"bandwidth\"\nsize = \"10 kHz\"\n");
  const Outcome outcome = rebound({"lumped", "a.toml"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.errors.find("bandwidth"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("synthesize"), std::string::npos) << outcome.errors;
  folder.write("without.toml", lumped_file);
  const auto without_time = [](const std::string& text) {
    return text.substr(0, text.find("wall_s"));
  };
  EXPECT_EQ(without_time(rebound({"lumped", "without.toml"}).output), without_time(outcome.output));
}

TEST_F(LumpedCommandTest, AContactThatNeverEndsReportsNoRestitution) {
  // Overdamped Kelvin-Voigt, c = 1000 > 2 sqrt(k m) = 268: x never returns to zero.
  std::string text = replaced(lumped_file, "hunt-crossley", "linear-kelvin-voigt");
  text = replaced(text, "3.5e6 N/m^1.5", "2e5 N/m");
  text = replaced(text, "17.63e4 N.s/m^2.5", "1000 N.s/m");
  text =
      replaced(text, "speed = \"15 m/s\"", "speed = \"1 m/s\"\nseparation = \"zero-deflection\"");
  folder.write("a.toml", text);
  const Outcome outcome = rebound({"lumped", "a.toml", "--json", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["error"]["code"], 3);
  EXPECT_EQ(json["error"]["file"], "a.toml");
  EXPECT_FALSE(json.contains("restitution"));
  EXPECT_FALSE(there("results/trace.csv"));
  EXPECT_FALSE(there("results/result.json"));
}

// Restitution of Hunt-Crossley depends on damping times speed over stiffness alone.
TEST_F(LumpedCommandTest, SensitivitiesArePrintedOnRequest) {
  folder.write("impact.toml", lumped_file);
  const Outcome outcome = rebound({"lumped", "impact.toml", "--sensitivities", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto by = nlohmann::json::parse(outcome.output)["sensitivities"];
  const auto slope = [&](const char* name, double value) {
    return by[name]["restitution"].get<double>() * value;
  };
  EXPECT_LT(slope("damping", 17.63e4), -0.1);
  EXPECT_NEAR(slope("damping", 17.63e4), slope("speed", 15.0), 1e-6);
  EXPECT_NEAR(slope("damping", 17.63e4), -slope("stiffness", 3.5e6), 1e-6);
  EXPECT_NEAR(slope("mass", 0.0896), 0.0, 1e-6);
  EXPECT_GT(by["speed"]["peak_force_N"].get<double>(), 0.0);
  folder.write("plate.toml",
               lumped_file + "[model.plate]\nstiffness = \"50 MN/m\"\nmass = \"2 kg\"\n");
  EXPECT_EQ(rebound({"lumped", "plate.toml", "--sensitivities"}).exit_code, 2);
}

TEST_F(LumpedCommandTest, StartingFilesRunAsTheyAre) {
  ASSERT_EQ(rebound({"init"}).exit_code, 0);
  EXPECT_EQ(rebound({"lumped", "lumped.toml"}).exit_code, 0);
  ASSERT_EQ(rebound({"lumped", "lumped.toml", "--out", "reference"}).exit_code, 0);
  for (const char* command : {"calibrate", "select", "benchmark"}) {
    const Outcome outcome = rebound({command, std::string(command) + ".toml"});
    EXPECT_EQ(outcome.exit_code, 0) << command << ": " << outcome.errors;
  }
  const std::string text = read_whole(folder.path() / "lumped.toml");
  EXPECT_NE(text.find("# Mass of the ball."), std::string::npos);
  EXPECT_EQ(rebound({"init"}).exit_code, 2);  // nothing is overwritten
  EXPECT_EQ(read_whole(folder.path() / "lumped.toml"), text);
}

}  // namespace
}  // namespace rebound::testing
