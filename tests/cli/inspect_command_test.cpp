// `init dataset`, `inspect`, and fits to what data sets state, as a user meets them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class InspectCommand : public ProgramTest {};

/// Two decelerations of 2 ms in multiples of free fall, with decimal commas and units in a row of
/// their own, as a recorder writes them; the offset of the amplifier is 3.
std::string recorder_file() {
  std::string text = "\xef\xbb\xbfRecorder;7\r\nTime;a1;a2\r\n(ms);(g);(g)\r\n";
  for (int i = 0; i < 1200; ++i) {
    const double t = 1e-2 * i, in = t - 5.0;
    const double wave = in > 0.0 && in < 2.0 ? std::sin(std::numbers::pi * in / 2.0) : 0.0;
    std::string line = std::to_string(t) + ";" +
                       std::to_string(3.0 + 0.5 * (i % 3 - 1) - 620 * wave) + ";" +
                       std::to_string(3.0 - 0.5 * (i % 3 - 1) - 1240 * wave) + "\r\n";
    std::replace(line.begin(), line.end(), '.', ',');
    text += line;
  }
  return text;
}

TEST_F(InspectCommand, AFileOfARecorderBecomesADataSetThatIsInspected) {
  folder.write("rec.csv", recorder_file());
  const Outcome init = rebound({"init", "dataset", "--from", "rec.csv", "--mass", "89.6 g",
                                "--diameter", "66.2 mm", "--speed", "5 m/s", "--out", "ball"});
  ASSERT_EQ(init.exit_code, 0) << init.errors;
  const std::string manifest = read_whole(folder.path() / "ball/dataset.toml");
  for (const char* part :
       {"acceleration = \"a1\"", "reversed = true", "baseline = \"before-contact\"",
        "channel = \"a2\"", "# GUESSED", "decimal comma"})
    EXPECT_NE(manifest.find(part), std::string::npos) << part << "\n" << manifest;
  const Outcome inspected = rebound({"inspect", "ball", "--json", "--out", "page"});
  ASSERT_EQ(inspected.exit_code, 0) << inspected.errors;
  const auto json = nlohmann::json::parse(inspected.output);
  EXPECT_EQ(json["schema"], 1);
  ASSERT_EQ(json["shots"].size(), 2u);
  const auto& numbers = json["shots"][0]["numbers"];
  EXPECT_NEAR(numbers["peak_force_N"]["value"].get<double>(), 0.0896 * 620 * 9.80665, 3.0);
  EXPECT_GT(numbers["peak_force_N"]["uncertainty"].get<double>(), 0.0);
  EXPECT_TRUE(there("page/report.html"));
  EXPECT_TRUE(there("page/inspection.json"));
}

TEST_F(InspectCommand, WhatNobodySaidIsAskedForWithFileLineAndKey) {
  folder.write("rec.csv", recorder_file());
  ASSERT_EQ(rebound({"init", "dataset", "--from", "rec.csv"}).exit_code, 0);
  const Outcome outcome = rebound({"inspect", "rec", "--out", "page"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("dataset.toml:9:8: sphere.mass = \"?\""), std::string::npos)
      << outcome.errors;
  EXPECT_FALSE(there("page"));
  EXPECT_EQ(rebound({"init", "dataset", "--from", "rec.csv"}).exit_code, 2);  // not overwritten
}

// What is not used is named, and no unit is guessed where the heading states one that is not known.
TEST_F(InspectCommand, AGuessNamesTheColumnsThatItDoesNotUse) {
  std::string text = "time [ms],force [tonf],load [lbf],stroke [mil],Kommentar\n";
  for (int i = 0; i < 30; ++i) text += std::to_string(i) + ",1.0,2.0,3.0,ok\n";
  folder.write("r.csv", text);
  ASSERT_EQ(rebound({"init", "dataset", "--from", "r.csv"}).exit_code, 0);
  const std::string manifest = read_whole(folder.path() / "r/dataset.toml");
  for (const char* part :
       {"# not used, force [tonf]: its unit is not known", "force = \"load [lbf]\"",
        "deflection = \"stroke [mil]\"", "# not used, Kommentar: not all of it is numbers"})
    EXPECT_NE(manifest.find(part), std::string::npos) << part << "\n" << manifest;
}

TEST_F(InspectCommand, ATableOfBallsBecomesAFolderABall) {
  folder.write("t.csv",
               "ball;drop [cm];rebound [cm];rebound_sd [cm];repeats\n"
               "red;100;64,0;0,5;10\nred;150;95,0;0,6;10\nblue;100;49,0;0,5;10\n");
  ASSERT_EQ(rebound({"init", "dataset", "--from", "t.csv", "--mass", "50 g", "--diameter", "60 mm"})
                .exit_code,
            0);
  const auto json = nlohmann::json::parse(rebound({"inspect", "t/ball-red", "--json"}).output);
  ASSERT_EQ(json["shots"].size(), 2u);
  const auto& restitution = json["shots"][0]["numbers"]["stated_restitution"];
  EXPECT_NEAR(restitution["value"].get<double>(), 0.8, 1e-6);
  EXPECT_NEAR(restitution["uncertainty"].get<double>(), 0.8 * 0.5 * 0.5 / 64 / std::sqrt(10.0),
              1e-6);
  EXPECT_TRUE(there("t/ball-blue/dataset.toml"));
}

struct BadTable {
  const char* name;
  std::string text;
  const char* place;
  const char* part;
};

class BadTableTest : public InspectCommand, public ::testing::WithParamInterface<BadTable> {};

/// File, line, column and reason; nothing is written.
TEST_P(BadTableTest, IsRefusedWithItsPlace) {
  std::filesystem::create_directories(folder.path() / "data");
  folder.write("data/t.csv", GetParam().text);
  folder.write("data/dataset.toml",
               "schema = 1\nname = \"b\"\n[sphere]\nmass = \"89.6 g\"\n"
               "diameter = \"66.2 mm\"\n[[shot]]\nspeed = \"5 m/s\"\n"
               "trace = \"t.csv\"\n");
  const Outcome outcome = rebound({"inspect", "data", "--out", "page"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_NE(outcome.errors.find(std::string("t.csv:") + GetParam().place), std::string::npos)
      << outcome.errors;
  EXPECT_NE(outcome.errors.find(GetParam().part), std::string::npos) << outcome.errors;
  EXPECT_FALSE(there("page"));
}

const std::string head = "time [ms],force [N]\n";

INSTANTIATE_TEST_SUITE_P(
    Cases, BadTableTest,
    ::testing::Values(BadTable{"Truncated", head + "0,1\n1,2\n2", "4:1:", "cut off"},
                      BadTable{"Corrupt", head + "0,1\n1,\x01\x02\n2,1\n", "3:3:", "no number"},
                      BadTable{"WrongUnit", "time [ms],force [mm]\n0,1\n1,2\n2,1\n",
                               "1:", "another unit"},
                      BadTable{"NoUnit", "time,force\n0,1\n1,2\n2,1\n", "1:", "no unit"},
                      BadTable{"NaN", head + "0,1\n1,nan\n2,1\n", "3:3:", "finite"},
                      BadTable{"TimeBackwards", head + "0,1\n2,2\n1,1\n", "4:1:", "increase"},
                      BadTable{"ManyColumns",
                               "time [ms]" +
                                   [] {
                                     std::string more;
                                     for (int i = 0; i < 9000; ++i) more += ",c";
                                     return more;
                                   }() +
                                   "\n0,1\n",
                               "1:", "columns"}),
    [](const auto& c) { return std::string(c.param.name); });

TEST_F(InspectCommand, ContradictionsFailWhereAskedFor) {
  std::string rows = "speed_m_s,restitution,restitution_uncertainty\n";
  for (int v = 4; v <= 14; v += 2)
    rows += std::to_string(v) + (v == 8 ? ",0.75" : ",0.60") + ",0.005\n";
  std::filesystem::create_directories(folder.path() / "data");
  folder.write("data/t.csv", rows);
  folder.write("data/dataset.toml",
               "schema = 1\nname = \"b\"\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n"
               "[[shot_table]]\nfile = \"t.csv\"\n[shot_table.columns]\nspeed = \"speed\"\n"
               "restitution = \"restitution\"\n"
               "restitution_uncertainty = \"restitution_uncertainty\"\n");
  const Outcome outcome = rebound({"inspect", "data", "--fail-on-contradiction"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output << outcome.errors;
  EXPECT_NE(outcome.output.find("CONTRADICTION  restitution-over-speed of b, 8 m/s"),
            std::string::npos)
      << outcome.output;
  EXPECT_EQ(rebound({"inspect", "data"}).exit_code, 0);
}

}  // namespace
}  // namespace rebound::testing
