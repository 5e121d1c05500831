#include "tests/cli/run_example.hpp"

namespace rebound::testing {
namespace {

class CompressCommandTest : public ProgramTest {};

const std::string compression_file = R"(schema = 1
[compression]
platens = 2
deflection = "4 mm"
steps = 10
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 60
[model.material]
elastic = "neo-hookean"
youngs_modulus = "5 MPa"
poisson_ratio = 0.4
modulus = "long-term"
[[model.material.branch]]
ratio = 0.5
relaxation_time = "1 ms"
)";

TEST_F(CompressCommandTest, SlowCompressionSeesTheLongTermModulusAlone) {
  folder.write("a.toml", compression_file);
  folder.write("b.toml",
               compression_file.substr(0, compression_file.find("[[model.material.branch")));
  const Outcome outcome = rebound({"compress", "a.toml", "--json", "--out", "one"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const char* key : {"peak_force_N", "peak_deflection_m", "contact_radius_peak_m",
                          "stiffness_N_m1_5", "work_J", "stored_J", "cells", "wall_s"})
    EXPECT_TRUE(json[key].is_number()) << key;
  EXPECT_NEAR(json["work_J"].get<double>() / json["stored_J"].get<double>(), 1.0, 0.01);
  ASSERT_EQ(rebound({"compress", "b.toml", "--out", "two"}).exit_code, 0);
  const std::string curve = read_whole(folder.path() / "one/curve.csv");
  EXPECT_TRUE(curve.starts_with("deflection_m,force_N,contact_radius_m,stored_J,work_J\n"))
      << curve;
  const auto force = [&](const char* file) {
    return nlohmann::json::parse(read_whole(folder.path() / file))["peak_force_N"].get<double>();
  };
  EXPECT_NEAR(force("one/result.json") / force("two/result.json"), 1.0, 1e-6);
  ASSERT_EQ(rebound({"compress", "one/effective.toml", "--out", "again"}).exit_code, 0);
  EXPECT_EQ(curve, read_whole(folder.path() / "again/curve.csv"));
}

TEST_F(CompressCommandTest, APathInTimeHasItsBranchesAndEndsWhereThePlateIsLeft) {
  folder.write("a.toml", replaced(compression_file, "steps = 10",
                                  "steps = 60\npath = \"triangle\"\nduration = \"4 ms\""));
  const Outcome outcome = rebound({"compress", "a.toml", "--json", "--out", "one"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_GT(json["contact_end_s"].get<double>(), 2e-3);
  EXPECT_LT(json["contact_end_s"].get<double>(), 4e-3);
  EXPECT_GT(json["work_J"].get<double>(), 0.0);
  EXPECT_TRUE(
      read_whole(folder.path() / "one/curve.csv").starts_with("time_s,deflection_m,force_N,"));
}

TEST_F(CompressCommandTest, BadFilesAreRefusedWithTheirKey) {
  const struct {
    const char *from, *to, *key;
  } cases[] = {{"\"4 mm\"", "\"90 mm\"", "compression.deflection"},
               {"platens = 2", "platens = 3", "compression.platens"},
               {"steps = 10", "steps = 10\npath = \"triangle\"", "compression.path"},
               {"steps = 10", "steps = 10\nduration = \"4 ms\"", "compression.duration"},
               {"poisson_ratio = 0.4", "poisson_ratio = 0.4995", "model.material.poisson_ratio"},
               {"\"89.6 g\"", "\"89.6 kg\"", "sphere.diameter"},
               {"tier = \"fem\"", "tier = \"lumped\"", "model.tier"}};
  for (const auto& [from, to, key] : cases) {
    folder.write("a.toml", replaced(compression_file, from, to));
    const Outcome outcome = rebound({"compress", "a.toml", "--json"});
    EXPECT_EQ(outcome.exit_code, 2) << to;
    const auto error = nlohmann::json::parse(outcome.output)["error"];
    EXPECT_EQ(error["key"], key) << outcome.output;
    EXPECT_TRUE(error["line"].is_number()) << outcome.output;
  }
}

TEST_F(CompressCommandTest, ExamplesOfTheFeTierWork) {
  for (const char* name : {"fem", "compression"}) run_example(folder, name);
}

TEST_F(CompressCommandTest, AnInterruptedRunKeepsWhatIsKnown) {
  folder.write("a.toml", replaced(replaced(compression_file, "cells = 60", "cells = 400"),
                                  "steps = 10", "steps = 20000"));
  const Outcome outcome =
      rebound({"compress", "a.toml", "--json", "--out", "results"}, {.interrupt_after_ms = 1500});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.output << outcome.errors;
  EXPECT_TRUE(there("results/incomplete.json"));
  EXPECT_TRUE(there("results/curve-incomplete.csv"));
  EXPECT_FALSE(there("results/result.json"));
}

}  // namespace
}  // namespace rebound::testing
