#include <map>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class FemCommandTest : public ProgramTest {};

TEST_F(FemCommandTest, PrintsTheContractsKeysAndTheMomentumRestitution) {
  folder.write("a.toml", fem_file);
  const Outcome outcome = rebound({"fem", "a.toml", "--json", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const char* key : {"restitution", "contact_time_s", "contact_time_1pct_s", "peak_force_N",
                          "peak_deflection_m", "mean_deflection_m", "rebound_speed_m_s",
                          "impulse_closure", "energy_closure", "wall_s", "restitution_momentum",
                          "cells", "steps", "contact_radius_peak_m", "vibrational_energy_share"})
    EXPECT_TRUE(json[key].is_number()) << key;
  EXPECT_TRUE(read_whole(folder.path() / "results/trace.csv")
                  .starts_with("time_s,force_N,deflection_m,pole_deflection_m,contact_radius_m,"));
}

TEST_F(FemCommandTest, OneCommandGivesFieldsAndTheReportThatMoves) {
  folder.write("a.toml", fem_file + "[controls]\nfield_frames = 12\n");
  const Outcome outcome = rebound({"fem", "a.toml", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE(read_whole(folder.path() / "results/fields/impact.pvd").find("frame-0008.vtu"),
            std::string::npos);
  EXPECT_NE(read_whole(folder.path() / "results/fields/frame-0008.vtu").find("von_mises_stress_Pa"),
            std::string::npos);
  const std::string report = read_whole(folder.path() / "results/report.html");
  EXPECT_NE(report.find("\"kind\":\"animation\""), std::string::npos);

  // The frames move nothing: the same trace without them, and a report that stands still.
  const std::string trace = read_whole(folder.path() / "results/trace.csv");
  folder.write("b.toml", fem_file);
  ASSERT_EQ(rebound({"fem", "b.toml", "--out", "still"}).exit_code, 0);
  EXPECT_EQ(read_whole(folder.path() / "still/trace.csv"), trace);
  EXPECT_FALSE(there("still/fields"));
  // Nor do they outlive a run that asks for none.
  ASSERT_EQ(rebound({"fem", "b.toml", "--out", "results"}).exit_code, 0);
  EXPECT_FALSE(there("results/fields/impact.pvd"));
  EXPECT_FALSE(there("results/fields/frame-0008.vtu"));
  EXPECT_EQ(read_whole(folder.path() / "still/report.html").find("\"kind\":\"animation\""),
            std::string::npos);
}

TEST_F(FemCommandTest, FieldsThatCannotBeWrittenAreExitFour) {
  folder.write("a.toml", fem_file + "[controls]\nfield_frames = 12\n");
  std::filesystem::create_directories(folder.path() / "results");
  folder.write("results/fields", "a file where the folder should be");
  const Outcome outcome = rebound({"fem", "a.toml", "--json", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.output;
  EXPECT_NE(
      nlohmann::json::parse(outcome.output)["error"]["file"].get<std::string>().find("fields"),
      std::string::npos);
  EXPECT_FALSE(there("results/result.json"));
}

TEST_F(FemCommandTest, OtherCommandsTakeAFileThatAsksForFields) {
  folder.write("a.toml", fem_file + "[controls]\nfield_frames = 12\n");
  const Outcome outcome = rebound({"drop", "a.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
}

TEST_F(FemCommandTest, CellsBeyondTheMemoryAreRefusedBeforeTheyAreMade) {
  folder.write("big.toml", replaced(fem_file, "cells = 60", "cells = 1000000"));
  Invocation limited{
      .arguments = {"/bin/bash", "-c",
                    "ulimit -v 1500000; exec " REBOUND_PROGRAM " fem big.toml --json"},
      .folder = folder.path()};
  const Outcome outcome = run_program(limited);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
  const auto error = nlohmann::json::parse(outcome.output)["error"];
  EXPECT_EQ(error["key"], "model.cells");
  EXPECT_EQ(error["value"], "1000000");
  EXPECT_NE(error["message"].get<std::string>().find("GB"), std::string::npos);
}

// The keys reach the tier: the load cell, the weight and the further branch show.
TEST_F(FemCommandTest, PlateAndEffectsActAndStayInTheEffectiveConfiguration) {
  folder.write("plain.toml", fem_file);
  folder.write("a.toml", fem_file + R"([model.plate]
stiffness = "50 MN/m"
[[model.effect]]
name = "relaxation"
size = 0.3
relaxation_time = "1 ms"
[[model.effect]]
name = "gravity"
size = 1
)");
  ASSERT_EQ(rebound({"fem", "plain.toml", "--out", "plain"}).exit_code, 0);
  const Outcome outcome = rebound({"fem", "a.toml", "--out", "one"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  ASSERT_EQ(rebound({"fem", "one/effective.toml", "--out", "two"}).exit_code, 0);
  const std::string effective = read_whole(folder.path() / "one/effective.toml");
  EXPECT_NE(effective.find("[model.plate]\nstiffness = \"50 MN/m\""), std::string::npos)
      << effective;
  EXPECT_NE(effective.find("name = \"relaxation\"\nsize = 0.3"), std::string::npos) << effective;
  const std::string trace = read_whole(folder.path() / "one/trace.csv");
  EXPECT_EQ(trace, read_whole(folder.path() / "two/trace.csv"));
  EXPECT_NE(trace.find("contact_force_N"), std::string::npos);
  const auto number = [&](const char* file, const char* key) {
    return nlohmann::json::parse(read_whole(folder.path() / file))[key].get<double>();
  };
  EXPECT_NE(number("one/result.json", "restitution"), number("plain/result.json", "restitution"));
}

TEST_F(FemCommandTest, AReferenceGivesEveryScalarAndTheTraceABar) {
  folder.write("a.toml", fem_file);
  const Outcome outcome = rebound({"fem", "a.toml", "--reference", "--json", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const char* key : {"restitution", "contact_time_s", "contact_time_1pct_s", "peak_force_N",
                          "peak_deflection_m", "mean_deflection_m", "rebound_speed_m_s"}) {
    ASSERT_TRUE(json["uncertainty"][key].is_number()) << key;
    EXPECT_GT(json["uncertainty"][key], 0.0) << key;
    EXPECT_TRUE(json["uncertainty_basis"][key]["method"].is_string()) << key;
  }
  EXPECT_GT(json["cells"], 300);  // the finest of the family
  // So few cells make no reference, and the words say so.
  EXPECT_FALSE(json["reference"]["beyond"].empty());
  const Outcome words = rebound({"fem", "a.toml", "--reference"});
  EXPECT_NE(words.output.find(" +- "), std::string::npos) << words.output;
  EXPECT_NE(words.output.find("reference                   no: "), std::string::npos)
      << words.output;
  const auto stored = nlohmann::json::parse(read_whole(folder.path() / "results/result.json"));
  EXPECT_EQ(stored["uncertainty"], json["uncertainty"]);
  const std::string trace = read_whole(folder.path() / "results/trace.csv");
  EXPECT_NE(trace.substr(0, trace.find('\n')).find(",force_uncertainty_N,deflection_uncertainty_m"),
            std::string::npos);
}

TEST_F(FemCommandTest, APlateThatMovesReadsItsLoadCell) {
  folder.write("a.toml", fem_file + "[model.plate]\nstiffness = \"50 MN/m\"\nmass = \"2 kg\"\n");
  const Outcome outcome = rebound({"fem", "a.toml", "--json", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const std::string trace = read_whole(folder.path() / "results/trace.csv");
  const std::string header = trace.substr(0, trace.find('\n'));
  for (const char* column : {"contact_force_N", "plate_displacement_m", "plate_spring_J"})
    EXPECT_NE(header.find(column), std::string::npos) << column;
}

TEST_F(FemCommandTest, AMeshMadeHereIsReadBackToTheSameTrace) {
  // With 1000 cells at 15 m/s the contact needs no grading beyond the default of `mesh`.
  folder.write("a.toml", replaced(fem_file, "cells = 60", "cells = 1000"));
  ASSERT_EQ(rebound({"fem", "a.toml", "--out", "one"}).exit_code, 0);
  ASSERT_EQ(
      rebound({"mesh", "--diameter", "66.2 mm", "--cells", "1000", "--out", "ball.msh"}).exit_code,
      0);
  folder.write("b.toml", replaced(fem_file, "cells = 60", "mesh = \"ball.msh\""));
  const Outcome outcome = rebound({"fem", "b.toml", "--out", "two"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(read_whole(folder.path() / "one/trace.csv"),
            read_whole(folder.path() / "two/trace.csv"));
}

TEST_F(FemCommandTest, AMeshOfAnotherBallIsRefused) {
  ASSERT_EQ(
      rebound({"mesh", "--diameter", "60 mm", "--cells", "60", "--out", "ball.msh"}).exit_code, 0);
  folder.write("b.toml", replaced(fem_file, "cells = 60", "mesh = \"ball.msh\""));
  const Outcome outcome = rebound({"fem", "b.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("ball.msh"), std::string::npos) << outcome.errors;
}

TEST_F(FemCommandTest, TheImplicitSchemeReportsTheSameScalarsAndFaults) {
  const std::string implicit =
      replaced(fem_file, "cells = 60", "scheme = \"implicit\"\ncells = 60");
  folder.write("explicit.toml", replaced(fem_file, "cells = 60", "cells = 240"));
  folder.write("implicit.toml", implicit);
  folder.write("short.toml", implicit + "[controls]\nend_time = \"0.5 ms\"\n");
  const auto read = [&](const char* file) {
    const Outcome outcome = rebound({"fem", file, "--json", "--out", "results"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  };
  const auto first = read("explicit.toml"), second = read("implicit.toml");
  for (const auto& [key, value] : first.items()) EXPECT_TRUE(second.contains(key)) << key;
  EXPECT_NEAR(second["restitution"], first["restitution"], 5e-3);
  EXPECT_NEAR(second["peak_deflection_m"].get<double>() / first["peak_deflection_m"].get<double>(),
              1.0, 1e-2);
  EXPECT_TRUE(read_whole(folder.path() / "results/trace.csv")
                  .starts_with("time_s,force_N,deflection_m,pole_deflection_m,contact_radius_m,"));

  EXPECT_EQ(rebound({"fem", "short.toml", "--out", "results"}).exit_code, 3);
  EXPECT_TRUE(there("results/incomplete.json"));
  EXPECT_FALSE(there("results/result.json"));
}

}  // namespace
}  // namespace rebound::testing
