// Blind trials of balls in finite elements, as a user runs them.
#include <filesystem>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class FemTrials : public ProgramTest {
 protected:
  Outcome generate(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), TRIAL_GENERATOR);
    arguments.insert(arguments.end(), {"--fem", REBOUND_PROGRAM});
    return run_program({.arguments = std::move(arguments), .folder = folder.path()});
  }
};

TEST_F(FemTrials, AreSealedDiagnosedAndScoredByThemselves) {
  const Outcome made =
      generate({"--out", "nulls", "--count", "2", "--seed", "3", "--only", "null"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_NE(read_whole(folder.path() / "nulls/truth/0001.json").find("\"tier\": \"fem\""),
            std::string::npos);
  const Outcome run = rebound({"trials", "nulls", "--ask-fem", "--json", "--table", "bodies.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["trials"], 0) << "no ball obeys a law";
  EXPECT_EQ(json["in_fem"]["trials"], 2);
  EXPECT_EQ(json["protocols"][0]["ask_fem"], true);
  EXPECT_EQ(json["in_fem"]["gates"][0]["what"], "false alarms on nulls");
  EXPECT_EQ(json["in_fem"]["gates"][0]["of"], 2);
  EXPECT_EQ(json["in_fem"]["gates"][0]["count"], 0);
  EXPECT_EQ(json["in_fem"]["confusion"]["nothing"]["agrees"], 2);
  const Outcome again = rebound({"trials", "--from-table", "bodies.csv", "--json"});
  EXPECT_EQ(again.output, run.output);
}

/// Every shot has a start of its own, which takes a delay of all shots: by its first order alone a
/// delay of many samples showed.
TEST_F(FemTrials, ADelayOfAllShotsShowsNothing) {
  const Outcome made =
      generate({"--out", "late", "--count", "1", "--seed", "3", "--only", "delay"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const auto truth = nlohmann::json::parse(read_whole(folder.path() / "late/truth/0001.json"));
  EXPECT_GT(truth["effects"][0]["size"].get<double>(), 0.05) << "of the contact: many samples";
  EXPECT_LT(truth["visible_chi_square"].get<double>(), 25.0);
  EXPECT_FALSE(truth["resolvable"].get<bool>());
}

TEST_F(FemTrials, WhatIsHiddenShowsAndTheDataDoNotSayIt) {
  const Outcome made =
      generate({"--out", "x", "--count", "1", "--seed", "11", "--only", "mullins-by-strain"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const auto truth = nlohmann::json::parse(read_whole(folder.path() / "x/truth/0001.json"));
  EXPECT_EQ(truth["families"], nlohmann::json({"history"}));
  EXPECT_GT(truth["visible_chi_square"], 25.0);
  // The size was searched beside a ball after a few steps, which settles for the label.
  EXPECT_LT(truth["visible_chi_square"].get<double>(),
            0.95 * truth["effects"][0]["visible_chi_square_alone"].get<double>());
  EXPECT_NE(truth["ball"]["deck"].get<std::string>().find("mullins = "), std::string::npos);
  for (const char* file : {"dataset.toml", "model.toml"})
    for (const char* word : {"fem", "nu 0", "elastic", "mullins", "history", "neo"})
      EXPECT_EQ(read_whole(folder.path() / "x/trials/0001" / file).find(word), std::string::npos)
          << word;
}

TEST_F(FemTrials, TheSameSeedGivesTheSameDataAndLumpedFormsAreRefused) {
  for (const char* out : {"a", "b"}) {
    const Outcome made = generate({"--out", out, "--count", "1", "--seed", "9", "--only", "null"});
    ASSERT_EQ(made.exit_code, 0) << made.errors;
  }
  for (const char* file : {"dataset.toml", "model.toml", "shot-01.csv", "shot-03.csv"})
    EXPECT_EQ(read_whole(folder.path() / "a/trials/0001" / file),
              read_whole(folder.path() / "b/trials/0001" / file));
  const Outcome lumped =
      generate({"--out", "c", "--count", "1", "--seed", "9", "--only", "prony-one"});
  EXPECT_EQ(lumped.exit_code, 2);
  EXPECT_NE(lumped.errors.find("prony-one"), std::string::npos) << lumped.errors;
  EXPECT_FALSE(there("c"));
  EXPECT_EQ(generate({"--out", "d", "--count", "1", "--seed", "9", "--only", "pair"}).exit_code, 2);
}

TEST_F(FemTrials, WhatIsBelievedMayBeInFiniteElementsToo) {
  const Outcome made = generate(
      {"--out", "doubted", "--count", "1", "--seed", "2", "--only", "null", "--believe-fem"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_NE(read_whole(folder.path() / "doubted/trials/0001/model.toml").find("tier = \"fem\""),
            std::string::npos);
  const Outcome run = rebound({"trials", "doubted", "--json", "--table", "doubted.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_TRUE(json["in_fem"].is_null()) << "a lumped model is believed there";
  EXPECT_EQ(json["fem_believed"]["trials"], 1);
  EXPECT_EQ(json["fem_believed"]["confusion"]["nothing"]["agrees"], 1);
  EXPECT_EQ(rebound({"trials", "--from-table", "doubted.csv", "--json"}).output, run.output);
  const Outcome of_points = run_program(
      {.arguments = {TRIAL_GENERATOR, "--out", "y", "--count", "1", "--seed", "1", "--believe-fem"},
       .folder = folder.path()});
  EXPECT_EQ(of_points.exit_code, 2);
  EXPECT_NE(of_points.errors.find("--fem PROGRAM"), std::string::npos) << of_points.errors;
}

TEST_F(FemTrials, WithoutSuchAProgramNothingIsWritten) {
  const Outcome none = run_program({.arguments = {TRIAL_GENERATOR, "--out", "x", "--count", "1",
                                                  "--seed", "1", "--fem", "/nowhere/rebound"},
                                    .folder = folder.path()});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.errors.find("/nowhere/rebound"), std::string::npos) << none.errors;
  EXPECT_FALSE(there("x"));
}

}  // namespace
}  // namespace rebound::testing
