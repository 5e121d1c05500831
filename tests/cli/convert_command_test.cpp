// `convert` and `drop` as a user meets them.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class ConvertCommand : public ProgramTest {};

const std::string convert_file = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[given]
convention = "restitution"
stiffness = "3.5e6 N/m^1.5"
restitution = 0.5
)";

TEST_F(ConvertCommand, GivesEveryConventionWithItsError) {
  folder.write("convert.toml", convert_file);
  const auto outcome = rebound({"convert", "convert.toml", "--json", "--out", "out"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  bool seen = false;
  for (const auto& row : json["conversions"])
    if (row["convention"] == "hunt-crossley/hunt-crossley") {
      seen = true;
      EXPECT_NEAR(row["by_formula"]["error"]["restitution"].get<double>(), 0.163, 1e-3);
      EXPECT_NEAR(row["matched"]["error"]["restitution"].get<double>(), 0.0, 1e-8);
    }
  EXPECT_TRUE(seen);
  EXPECT_TRUE(there("out/convert.json"));
  EXPECT_NE(rebound({"convert", "convert.toml"}).output.find("by formula"), std::string::npos);
}

TEST_F(ConvertCommand, BadInputNamesTheKey) {
  const std::pair<std::string, int> cases[] = {
      {replaced(convert_file, "0.5", "1.0"), 2},
      {replaced(convert_file, "0.5", "1.3"), 2},
      {replaced(convert_file, "3.5e6 N/m^1.5", "3.5e6 N/m"), 2},
      {replaced(convert_file, "\"restitution\"", "\"bounce\""), 2},
      {replaced(convert_file, "[given]", "check_speed = \"5 m/s\"\n[given]"), 2},
  };
  for (const auto& [text, code] : cases) {
    folder.write("convert.toml", text);
    const Outcome outcome = rebound({"convert", "convert.toml", "--json"});
    EXPECT_EQ(outcome.exit_code, code) << text;
    EXPECT_FALSE(nlohmann::json::parse(outcome.output)["error"]["key"].is_null()) << text;
  }
}

// Lines for a code, errors against what was given and against FE, and what is refused.
TEST_F(ConvertCommand, ToACode) {
  folder.write("law.toml", replaced(replaced(convert_file, "\"restitution\"\n",
                                             "\"law\"\nlaw = \"hunt-crossley\"\n"),
                                    "stiffness = \"3.5e6 N/m^1.5\"\nrestitution = 0.5\n",
                                    "[given.parameters]\nexponent = 1.5\n"
                                    "stiffness = \"3.5e6 N/m^1.5\"\n"
                                    "damping = \"17.63e4 N.s/m^2.5\"\n"));
  for (const char* code : {"lammps", "liggghts", "yade", "mercurydpm", "chrono", "simbody", "drake",
                           "mujoco", "bullet", "ode", "sdf", "urdf"}) {
    const auto outcome = rebound({"convert", "law.toml", "--to", code});
    EXPECT_EQ(outcome.exit_code, 0) << code << outcome.errors;
    EXPECT_NE(outcome.output.find("holds for 89.6 g, 66.2 mm, at 15 m/s"), std::string::npos);
  }
  const auto lammps = rebound({"convert", "law.toml", "--to", "lammps", "--speeds", "5 m/s",
                               "15 m/s", "--json", "--out", "out"});
  ASSERT_EQ(lammps.exit_code, 0) << lammps.errors;
  const auto json = nlohmann::json::parse(lammps.output);
  EXPECT_NE(json["lines"].get<std::string>().find("pair_style granular"), std::string::npos);
  EXPECT_EQ(json["errors"].size(), 2u);
  EXPECT_NEAR(json["errors"][1]["law_error"]["restitution"].get<double>(), 0.0, 1e-8);
  EXPECT_TRUE(json["errors"][1]["fem_error"].is_null());
  EXPECT_TRUE(there("out/convert.json"));
}

TEST_F(ConvertCommand, ToACodeRefusals) {
  folder.write("convert.toml", convert_file);
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"--to", "granular"}, "--to"},
      {{"--fem", "fem.toml"}, "--fem"},
      {{"--speeds", "5 m/s"}, "--speeds"},
      {{"--to", "ode", "--step", "0.1"}, "--step"},
      {{"--to", "ode", "--step", "0.1 m"}, "--step"},
      {{"--to", "ode", "--speeds", "-5 m/s"}, "--speeds"},
  };
  for (const auto& [further, key] : cases) {
    std::vector<std::string> arguments{"convert", "convert.toml", "--json"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    const Outcome outcome = rebound(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << key;
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["error"]["key"], key);
  }
}

class DropCommand : public ProgramTest {};

TEST_F(DropCommand, ModelAndCalibration) {
  folder.write("impact.toml", lumped_file);
  const auto plain = rebound({"drop", "impact.toml", "--json"});
  ASSERT_EQ(plain.exit_code, 0) << plain.errors;
  const auto json = nlohmann::json::parse(plain.output);
  EXPECT_NEAR(json["speed_m_s"].get<double>(), 5.94, 0.002);
  EXPECT_TRUE(json["interval"].is_null());
  EXPECT_EQ(json["regulation"]["restitution"][0], 0.522);

  ASSERT_EQ(rebound({"lumped", "impact.toml", "--out", "reference"}).exit_code, 0);
  folder.write("calibrate.toml",
               "schema = 1\nlaw = \"linear-kelvin-voigt\"\n[[reference]]\n"
               "folder = \"reference\"\n");
  ASSERT_EQ(rebound({"calibrate", "calibrate.toml", "--out", "found"}).exit_code, 0);
  const auto fitted = rebound({"drop", "found", "--json"});
  ASSERT_EQ(fitted.exit_code, 0) << fitted.errors;
  const auto with = nlohmann::json::parse(fitted.output);
  EXPECT_LT(with["interval"][0].get<double>(), with["restitution"].get<double>());
  EXPECT_GT(with["interval"][1].get<double>(), with["restitution"].get<double>());
}

TEST_F(DropCommand, Refusals) {
  folder.write("impact.toml", lumped_file);
  EXPECT_EQ(rebound({"drop", "impact.toml", "--height", "1.8"}).exit_code, 2);
  EXPECT_EQ(rebound({"drop", "impact.toml", "--height", "-1 m"}).exit_code, 2);
  EXPECT_EQ(rebound({"drop", "nothing.toml"}).exit_code, 4);
  folder.write("calibration.json", "{\"schema\": 1");
  EXPECT_EQ(rebound({"drop", "calibration.json"}).exit_code, 5);
}

}  // namespace
}  // namespace rebound::testing
