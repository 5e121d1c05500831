// `campaign`: members, resumption, refusals. What takes long stands in campaign_kills_test.cpp.
#include <fstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

const std::string speeds = R"(schema = 1
base = "ball.toml"
[design]
kind = "grid"
[[design.factor]]
key = "impact.speed"
low = "5 m/s"
high = "25 m/s"
points = 5
)";

const std::string many = R"(schema = 1
base = "ball.toml"
[design]
kind = "sobol"
count = 3000
[[design.factor]]
key = "impact.speed"
low = "1 m/s"
high = "30 m/s"
spacing = "logarithmic"
[[design.factor]]
key = "model.damping"
low = "1e4 N.s/m^2.5"
high = "20e4 N.s/m^2.5"
)";

class CampaignCommand : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("ball.toml", lumped_file);
    folder.write("speeds.toml", speeds);
    folder.write("many.toml", many);
  }

  nlohmann::json run(std::vector<std::string> arguments, Invocation how = {}) const {
    arguments.insert(arguments.begin(), "campaign");
    arguments.push_back("--json");
    const Outcome outcome = rebound(arguments, how);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
    return nlohmann::json::parse(outcome.output, nullptr, false);
  }

  std::string table(const std::string& file, const std::string& store) const {
    run({"query", file, "--out", store, "--csv", "table.csv"});
    return read_whole(folder.path() / "table.csv");
  }

  /// The error of a campaign file.
  nlohmann::json refusal(const std::string& text, int exit_code = 2) const {
    folder.write("bad.toml", text);
    const Outcome outcome = rebound({"campaign", "bad.toml", "--json", "--out", "bad"});
    EXPECT_EQ(outcome.exit_code, exit_code) << text;
    EXPECT_FALSE(there("bad")) << "written for a file that is refused";
    return nlohmann::json::parse(outcome.output)["error"];
  }
};

TEST_F(CampaignCommand, AMemberIsTheImpactOfItsFile) {
  const auto done = run({"speeds.toml", "--out", "store"});
  EXPECT_EQ(done["members"], 5);
  EXPECT_EQ(done["run"], 5);
  EXPECT_EQ(done["failed"], 0);
  std::istringstream rows(table("speeds.toml", "store"));
  std::string heading, row;
  std::getline(rows, heading);
  EXPECT_EQ(heading.substr(0, 52), "member,impact.speed,restitution,contact_time_s,conta");
  for (const double speed : {5.0, 10.0, 15.0, 20.0, 25.0}) {
    std::getline(rows, row);
    folder.write("one.toml", replaced(lumped_file, "15 m/s", std::to_string(speed) + " m/s"));
    const auto single = nlohmann::json::parse(rebound({"lumped", "one.toml", "--json"}).output);
    std::istringstream cells(row);
    std::string member, value, restitution, time;
    for (std::string* cell : {&member, &value, &restitution, &time})
      std::getline(cells, *cell, ',');
    EXPECT_EQ(std::stod(value), speed);
    EXPECT_EQ(std::stod(restitution), single["restitution"].get<double>()) << speed;
    EXPECT_EQ(std::stod(time), single["contact_time_s"].get<double>()) << speed;
  }
}

TEST_F(CampaignCommand, RepeatedItRunsNothingAndAWiderOneWhatIsMissing) {
  run({"speeds.toml", "--out", "store"});
  const std::string first = table("speeds.toml", "store");
  const auto again = run({"speeds.toml", "--out", "store"});
  EXPECT_EQ(again["run"], 0);
  EXPECT_EQ(again["found"], 5);
  EXPECT_EQ(table("speeds.toml", "store"), first);
  folder.write("wider.toml", replaced(speeds, "points = 5", "points = 9"));
  const auto wider = run({"wider.toml", "--out", "store"});
  EXPECT_EQ(wider["found"], 5);
  EXPECT_EQ(wider["run"], 4);
  // Of two campaigns in one store the file is to be named.
  EXPECT_EQ(rebound({"campaign", "query", "store"}).exit_code, 2);
}

TEST_F(CampaignCommand, ShardsAndRanksTogetherAreTheWhole) {
  run({"many.toml", "--out", "whole", "--threads", "1"});
  const std::string whole = table("many.toml", "whole");
  for (const char* shard : {"1/3", "2/3"}) run({"many.toml", "--out", "parts", "--shard", shard});
  const auto rank = run({"many.toml", "--out", "parts"},
                        {.environment = {"OMPI_COMM_WORLD_RANK=2", "OMPI_COMM_WORLD_SIZE=3"}});
  EXPECT_EQ(rank["members"], 1000);
  EXPECT_TRUE(there("parts/shard-00003-of-00003.sqlite"));
  EXPECT_EQ(table("many.toml", "parts"), whole);
  // Another division finds what these have run; a store alone knows its campaign.
  EXPECT_EQ(run({"many.toml", "--out", "parts"})["run"], 0);
  EXPECT_EQ(run({"query", "parts", "--csv", "again.csv"})["complete"], true);
  EXPECT_EQ(read_whole(folder.path() / "again.csv"), whole);
}

// The launcher itself: three ranks, each with a part and a file of its own.
TEST_F(CampaignCommand, RanksOfMpirunTogetherAreTheWhole) {
  run({"many.toml", "--out", "whole"});
  const Outcome outcome = run_program(
      {.arguments = {MPIRUN, "--oversubscribe", "-n", "3", REBOUND_PROGRAM, "campaign", "many.toml",
                     "--out", "ranks", "--threads", "1"},
       .folder = folder.path(),
       .environment = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"}});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output << outcome.errors;
  for (const char* file : {"ranks/shard-00001-of-00003.sqlite", "ranks/shard-00002-of-00003.sqlite",
                           "ranks/shard-00003-of-00003.sqlite"})
    EXPECT_TRUE(there(file)) << file;
  EXPECT_EQ(table("many.toml", "ranks"), table("many.toml", "whole"));
}

TEST_F(CampaignCommand, TracesAreKeptWhereTheyAreAskedFor) {
  folder.write("traced.toml", replaced(speeds, "schema = 1\n", "schema = 1\ntraces = true\n"));
  run({"traced.toml", "--out", "store"});
  run({"query", "traced.toml", "--out", "store", "--traces", "traces.csv"});
  std::istringstream rows(read_whole(folder.path() / "traces.csv"));
  std::string heading, row;
  std::getline(rows, heading);
  EXPECT_EQ(heading, "member,time_s,force_N,deflection_m");
  // The second member's, line by line, is that of the impact of its file.
  folder.write("one.toml", replaced(lumped_file, "15 m/s", "10 m/s"));
  ASSERT_EQ(rebound({"lumped", "one.toml", "--out", "one"}).exit_code, 0);
  std::istringstream single(read_whole(folder.path() / "one" / "trace.csv"));
  std::getline(single, heading);
  int compared = 0;
  while (std::getline(rows, row))
    if (row.starts_with("1,")) {
      std::string expected;
      std::getline(single, expected);
      EXPECT_EQ(row.substr(2), expected);
      ++compared;
    }
  EXPECT_GT(compared, 100);
  EXPECT_EQ(run({"traced.toml", "--out", "store"})["run"], 0);
  // The same members without traces are other results, and of a campaign without them none come.
  EXPECT_EQ(run({"speeds.toml", "--out", "store"})["run"], 5);
  EXPECT_EQ(rebound({"campaign", "query", "speeds.toml", "--out", "store", "--traces", "t.csv"})
                .exit_code,
            2);
}

TEST_F(CampaignCommand, AMemberThatCannotBeRunIsKeptWithItsReason) {
  folder.write("sizes.toml", R"(schema = 1
base = "ball.toml"
[design]
kind = "grid"
[[design.factor]]
key = "sphere.diameter"
values = ["66.2 mm", "400 mm"]
)");
  const auto done = run({"sizes.toml", "--out", "store"});
  EXPECT_EQ(done["failed"], 1);
  EXPECT_NE(table("sizes.toml", "store").find("implies a density"), std::string::npos);
  const auto again = run({"sizes.toml", "--out", "store"});
  EXPECT_EQ(again["run"], 0);
  EXPECT_EQ(again["failed"], 1);
}

TEST_F(CampaignCommand, BadFilesAreRefusedWithTheirKey) {
  const auto key_of = [&](const std::string& from, const std::string& to) {
    const auto error = refusal(replaced(speeds, from, to));
    EXPECT_FALSE(error["file"].is_null()) << to;
    return error["key"].get<std::string>();
  };
  EXPECT_EQ(key_of("impact.speed", "impact.sped"), "design.factor[0].key");
  EXPECT_EQ(key_of("impact.speed", "model.plate.stiffness"), "design.factor[0].key");
  EXPECT_EQ(key_of("impact.speed", "model.law"), "design.factor[0].key");
  EXPECT_EQ(key_of("5 m/s", "30 m/s"), "design.factor[0].high");
  EXPECT_EQ(key_of("5 m/s", "5 mm"), "design.factor[0].low");
  EXPECT_EQ(key_of("\"5 m/s\"", "5"), "design.factor[0].low");
  EXPECT_EQ(key_of("5 m/s", "-5 m/s"), "design.factor[0].low");
  EXPECT_EQ(key_of("points = 5", "points = 1"), "design.factor[0].points");
  EXPECT_EQ(key_of("points = 5", ""), "design.factor[0].points");
  EXPECT_EQ(key_of("points = 5", "points = 10000001"), "design.factor[0].points");
  EXPECT_EQ(key_of("\"grid\"", "\"grid\"\ncount = 7"), "design.count");
  EXPECT_EQ(key_of("\"grid\"", "\"grid\"\nseed = 7"), "design.seed");
  EXPECT_EQ(key_of("\"grid\"", "\"sobol\""), "design.factor[0].points");
  EXPECT_EQ(key_of("\"grid\"", "\"sobel\""), "design.kind");
  EXPECT_EQ(key_of("points = 5", "values = [\"5 m/s\"]"), "design.factor[0].values");
  EXPECT_EQ(key_of("schema = 1\nbase = \"ball.toml\"", "schema = 1"), "base");
  const std::string factor = speeds.substr(speeds.find("[[design"));
  EXPECT_EQ(refusal(speeds + factor)["key"], "design.factor[1].key");
  const std::string mass = R"([[design.factor]]
key = "sphere.mass"
low = "80 g"
high = "90 g"
points = 5000000
)";
  EXPECT_EQ(refusal(speeds + mass)["key"], "design");  // 25 million members
}

TEST_F(CampaignCommand, AMissingOrBadBaseFileIsNamed) {
  EXPECT_NE(refusal(replaced(speeds, "ball.toml", "none.toml"), 4)["file"].dump().find("none.toml"),
            std::string::npos);
  folder.write("broken.toml", replaced(lumped_file, "15 m/s", "15 mm"));
  const auto error = refusal(replaced(speeds, "ball.toml", "broken.toml"));
  EXPECT_NE(error["file"].dump().find("broken.toml"), std::string::npos);
  EXPECT_EQ(error["key"], "impact.speed");
}

TEST_F(CampaignCommand, ADamagedStoreIsExitFive) {
  run({"speeds.toml", "--out", "store"});
  const auto file = folder.path() / "store" / "shard-00001-of-00001.sqlite";
  std::string text = read_whole(file);
  text.replace(0, 8, "damaged!");
  std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(rebound({"campaign", "speeds.toml", "--out", "store"}).exit_code, 5);
  EXPECT_EQ(rebound({"campaign", "query", "speeds.toml", "--out", "store"}).exit_code, 5);
  EXPECT_EQ(read_whole(file), text);
}

TEST_F(CampaignCommand, BadUsageIsRefused) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"speeds.toml", "--shard", "4/3"},
        {"speeds.toml", "--csv", "x.csv"},
        {"speeds.toml", "--traces", "x.csv"},
        {"one.toml", "two.toml"}}) {
    std::vector<std::string> all{"campaign"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(rebound(all).exit_code, 2) << arguments[0];
  }
  EXPECT_EQ(rebound({"campaign", "query", "speeds.toml", "--out", "none"}).exit_code, 4);
}

}  // namespace
}  // namespace rebound::testing
