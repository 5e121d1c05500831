#include "comparisons/discrepancy/trials/trial_score.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "comparisons/io/results/digest.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

TrialTruth hidden(int trial, const std::string& family, const std::string& name,
                  double visible = 100.0) {
  return {.trial = trial,
          .effects = {{.family = family, .form = "some " + name, .registry_name = name}},
          .visible_chi_square = visible};
}

TrialOutcome said(int trial, const std::string& verdict, const std::string& family = "",
                  const std::string& named = "") {
  TrialOutcome outcome{.trial = trial, .verdict = verdict, .family = family, .named = named};
  if (!named.empty()) outcome.candidates = {{named}};
  return outcome;
}

const TrialGate& gate(const TrialScores& scores, const std::string& what) {
  for (const TrialGate& one : scores.gates)
    if (one.what == what) return one;
  throw std::runtime_error("no gate " + what);
}

// 2 of 20: Wilson 1927 gives [0.028, 0.301].
TEST(TrialScoreTest, WilsonInterval) {
  const Share share{.count = 2, .of = 20};
  EXPECT_NEAR(share.low(), 0.0279, 1e-4);
  EXPECT_NEAR(share.high(), 0.3010, 1e-4);
  EXPECT_EQ(Share{}.low(), 0.0);
  EXPECT_EQ(Share{}.high(), 1.0);
}

TEST(TrialScoreTest, AFalseAlarmIsAGapSaidOfANull) {
  const TrialScores scores =
      score_trials({said(1, "agrees"), said(2, "missing", "elastic", "force-exponent"),
                    said(3, "insufficient-data"), said(4, "unexplained")},
                   {{.trial = 1}, {.trial = 2}, {.trial = 3}, {.trial = 4}});
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.count, 2);
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.of, 4);
  EXPECT_FALSE(gate(scores, "false alarms on nulls").passes());
}

TEST(TrialScoreTest, RightWrongAndOpen) {
  const TrialScores scores = score_trials(
      {said(1, "missing", "memory", "relaxation"), said(2, "family", "memory"), said(3, "one-of"),
       said(4, "missing", "elastic", "force-exponent"), said(5, "agrees")},
      {hidden(1, "memory", "relaxation"), hidden(2, "memory", "relaxation"),
       hidden(3, "memory", "relaxation"), hidden(4, "memory", "relaxation"),
       hidden(5, "memory", "relaxation", 3.0)});
  EXPECT_EQ(gate(scores, "family right").share.count, 2);
  EXPECT_EQ(gate(scores, "family right").share.of, 4) << "what cannot be seen does not count";
  EXPECT_EQ(gate(scores, "wrong family").share.count, 1);
  EXPECT_EQ(gate(scores, "confidently wrong name").share.count, 1);
  EXPECT_EQ(gate(scores, "name right or in the set").share.count, 1);
  EXPECT_EQ(scores.confusion.at("memory").at("elastic"), 1);
}

TEST(TrialScoreTest, AFaultOfTheMeasurementIsAFamily) {
  const TrialScores scores =
      score_trials({said(1, "measurement-fault"), said(2, "unexplained")},
                   {hidden(1, "measurement", "droop"), hidden(2, "out_of_family", "")});
  EXPECT_EQ(gate(scores, "family right").share.count, 1);
  EXPECT_EQ(gate(scores, "outside every family: said so").share.count, 1);
}

TEST(TrialScoreTest, TrialsWithoutTheirTruthsAreRefused) {
  EXPECT_EQ(testing::refusal_of([] { score_trials({said(1, "agrees")}, {}); }).code(),
            ExitCode::corrupt_store);
  EXPECT_EQ(testing::refusal_of([] { score_trials({said(1, "agrees")}, {{.trial = 2}}); }).code(),
            ExitCode::corrupt_store);
}

TEST(TrialOutcomeTest, ReadsWhatItWrites) {
  TrialOutcome outcome = said(7, "missing", "rate", "linear-dashpot");
  outcome.size = 1.5;
  outcome.size_low = 1.0;
  outcome.held_out_before = 3.25;
  outcome.warnings = {"one"};
  const TrialOutcome again = trial_outcome_from(dump(to_json(outcome)), "7.json");
  EXPECT_EQ(dump(to_json(again)), dump(to_json(outcome)));
  EXPECT_EQ(testing::refusal_of([] { trial_outcome_from("{}", "7.json"); }).code(),
            ExitCode::corrupt_store);
}

TEST(TrialTruthTest, ATruthThatWasChangedIsRefused) {
  const testing::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "truth");
  const std::string text =
      R"({"trial": 1, "visible_chi_square": 0.0, "effects": [], "noise": {"colour": "white", "stated": "right"}})";
  std::ofstream(folder.path() / "truth" / "0001.json") << text;
  std::ofstream(folder.path() / "sealed.txt") << sha256(text) << "  truth/0001.json\n";
  ASSERT_EQ(read_truths(folder.path()).size(), 1u);
  std::ofstream(folder.path() / "truth" / "0001.json") << text << "\n";
  EXPECT_EQ(testing::refusal_of([&] { read_truths(folder.path()); }).code(),
            ExitCode::corrupt_store);
}

}  // namespace
}  // namespace rebound
