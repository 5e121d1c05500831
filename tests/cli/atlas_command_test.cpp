// `atlas` and `benchmark --audit` on meshes small enough for seconds.
#include <fstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class AtlasCommand : public ProgramTest {};

TEST_F(AtlasCommand, MapsAreWrittenAndAKilledOneGoesOn) {
  const auto grid = [&](const std::string& losses) {
    folder.write("grid.toml", "schema = 1\nspeeds = [0.03, 0.08]\nloss_factors = [" + losses +
                                  "]\npoisson_ratios = [0.4]\nrelaxation_times = [0.1]\n"
                                  "cells = 100\n");
  };
  grid("0.05, 0.1");
  const auto first = rebound({"atlas", "grid.toml", "--json", "--out", "atlas"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const auto json = nlohmann::json::parse(first.output);
  EXPECT_EQ(json["impacts"], 4);
  EXPECT_EQ(json["impacts_run"], 4);
  EXPECT_EQ(json["impacts_failed"], 0);
  for (const char* name : {"atlas/atlas.json", "atlas/atlas.csv", "atlas/report.html"})
    EXPECT_TRUE(there(name)) << name;
  // Two of the four are there, as after a kill: only the others are run. The mesh is the same, for
  // the stiffer ball has the smaller contact.
  grid("0.1");
  ASSERT_EQ(rebound({"atlas", "grid.toml", "--out", "killed"}).exit_code, 0);
  grid("0.05, 0.1");
  const auto again = rebound({"atlas", "grid.toml", "--json", "--out", "killed"});
  const auto resumed = nlohmann::json::parse(again.output);
  EXPECT_EQ(resumed["impacts_run"], 2);
  EXPECT_TRUE(resumed["spreads"] == json["spreads"]);
  // Slower impacts have a smaller contact and another mesh: nothing of the old one is used.
  folder.write("grid.toml",
               "schema = 1\nspeeds = [0.02, 0.08]\nloss_factors = [0.1]\n"
               "poisson_ratios = [0.4]\nrelaxation_times = [0.1]\ncells = 100\n");
  const auto slower = rebound({"atlas", "grid.toml", "--json", "--out", "killed"});
  EXPECT_EQ(nlohmann::json::parse(slower.output)["impacts_run"], 2);
  grid("0.05, 0.1");
  const auto repeated = rebound({"atlas", "grid.toml", "--json", "--out", "atlas"});
  EXPECT_EQ(nlohmann::json::parse(repeated.output)["impacts_run"], 0);
  std::ofstream(folder.path() / "atlas" / "impacts.sqlite") << "{}";
  EXPECT_EQ(rebound({"atlas", "grid.toml", "--out", "atlas"}).exit_code, 5);
}

TEST_F(AtlasCommand, BadGridNamesTheKey) {
  for (const char* line : {"speeds = [0.9]\n", "speeds = [0.1, 0.05]\n", "cells = 1\n",
                           "loss_factors = []\n", "colours = [1]\n"}) {
    folder.write("grid.toml", std::string("schema = 1\n") + line);
    const auto outcome = rebound({"atlas", "grid.toml", "--json", "--out", "atlas"});
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_FALSE(nlohmann::json::parse(outcome.output)["error"]["key"].is_null()) << line;
  }
}

TEST_F(AtlasCommand, AuditGivesEachAssumptionANumber) {
  folder.write("ball.toml", replaced(fem_file, "cells = 60", "cells = 120"));
  const auto outcome = rebound(
      {"benchmark", "--audit", "ball.toml", "--speeds", "5", "15", "--json", "--out", "audit"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["assumptions"].size(), 10u);
  for (const auto& row : json["assumptions"]) {
    EXPECT_FALSE(row["sentence"].get<std::string>().empty());
    EXPECT_NE(row["verdict"], "not-run") << row["id"] << ": " << row["sentence"];
    EXPECT_EQ(row["errors"].size(), 2u) << row["id"];
  }
  EXPECT_TRUE(there("audit/audit.json"));
  EXPECT_EQ(rebound({"benchmark", "--audit", "ball.toml", "--speeds", "5"}).exit_code, 2);
}

TEST_F(AtlasCommand, DropTestOfAnFeBall) {
  folder.write("ball.toml", replaced(fem_file, "cells = 60", "cells = 120"));
  const auto outcome = rebound({"drop", "ball.toml", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_TRUE(json["interval"].is_null());
  EXPECT_GT(json["restitution"].get<double>(), 0.5);
}

}  // namespace
}  // namespace rebound::testing
