#include "comparisons/discrepancy/trials/trial_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "comparisons/discrepancy/trials/trial_report.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "comparisons/io/report/check.hpp"
#include "comparisons/io/results/digest.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

using testing::gate;
using testing::hidden;
using testing::nothing_hidden;
using testing::said;
using testing::trials_of;

// 2 of 20: Wilson 1927 gives [0.028, 0.301].
TEST(TrialScoreTest, WilsonInterval) {
  const Share share{.count = 2, .of = 20};
  EXPECT_NEAR(share.low(), 0.0279, 1e-4);
  EXPECT_NEAR(share.high(), 0.3010, 1e-4);
  EXPECT_EQ(Share{}.low(), 0.0);
  EXPECT_EQ(Share{}.high(), 1.0);
}

TEST(TrialScoreTest, AFalseAlarmIsAGapSaidOfANull) {
  TrialTruth misstated = nothing_hidden(4);
  misstated.noise_stated = "twice";
  const TrialScores scores =
      score_trials(trials_of({said(1, "agrees"), said(2, "missing", "elastic", "force-exponent"),
                              said(3, "insufficient-data"), said(4, "unexplained")},
                             {nothing_hidden(1), nothing_hidden(2), nothing_hidden(3), misstated}));
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.count, 2);
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.of, 4);
  EXPECT_FALSE(gate(scores, "false alarms on nulls").passes());
  EXPECT_EQ(gate(scores, "false alarms on nulls, noise misstated by 2").share.count, 1);
  EXPECT_EQ(gate(scores, "false alarms on nulls, noise misstated by 2").share.of, 1);
}

TEST(TrialScoreTest, AnErrorIsNoSilence) {
  const TrialScores scores = score_trials(
      trials_of({said(1, "agrees"), said(2, "failed"), said(3, "failed")},
                {nothing_hidden(1), nothing_hidden(2), hidden(3, "memory", "relaxation")}));
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.of, 1);
  EXPECT_EQ(gate(scores, "family right").share.of, 1);
  EXPECT_EQ(scores.without_answer, 2);
  EXPECT_NE(to_text(scores).find("2 of them ended in an error"), std::string::npos);
}

TEST(TrialScoreTest, RightWrongAndOpen) {
  const TrialScores scores = score_trials(trials_of(
      {said(1, "missing", "memory", "relaxation"), said(2, "family", "memory"), said(3, "one-of"),
       said(4, "missing", "elastic", "force-exponent"), said(5, "agrees")},
      {hidden(1, "memory", "relaxation"), hidden(2, "memory", "relaxation"),
       hidden(3, "memory", "relaxation"), hidden(4, "memory", "relaxation"),
       hidden(5, "memory", "relaxation", 3.0)}));
  EXPECT_EQ(gate(scores, "family right").share.count, 2);
  EXPECT_EQ(gate(scores, "family right").share.of, 4) << "what cannot be seen does not count";
  EXPECT_EQ(scores.not_visible, 1);
  EXPECT_EQ(gate(scores, "wrong family").share.count, 1);
  EXPECT_EQ(gate(scores, "abstained from a family").share.count, 1);
  EXPECT_EQ(gate(scores, "confidently wrong name").share.count, 1);
  EXPECT_EQ(gate(scores, "name right or in the set").share.count, 1);
  EXPECT_EQ(scores.confusion.at("memory").at("elastic"), 1);
  EXPECT_EQ(scores.confusion_by_name.at("relaxation").at("force-exponent"), 1);
  EXPECT_EQ(scores.confusion_by_name.at("relaxation").at("family"), 1);
}

TEST(TrialScoreTest, AFaultOfTheMeasurementIsAFamily) {
  const TrialScores scores =
      score_trials(trials_of({said(1, "measurement-fault"), said(2, "unexplained")},
                             {hidden(1, "measurement", "droop"), hidden(2, "out_of_family", "")}));
  EXPECT_EQ(gate(scores, "family right").share.count, 1);
  EXPECT_EQ(gate(scores, "outside every family: said so").share.count, 1);
}

TEST(TrialScoreTest, AFormWithoutANearestNameHasNoRightOne) {
  const TrialScores scores =
      score_trials(trials_of({said(1, "measurement-fault")}, {hidden(1, "measurement", "")}));
  EXPECT_EQ(gate(scores, "name right or in the set").share.of, 0);
  EXPECT_EQ(gate(scores, "family right").share.of, 1);
}

// Curves of a pull are adhesion by another law; a curve over the deflection is no one effect.
TEST(TrialScoreTest, TheFreeFormOfOneEffectSaysThatEffect) {
  std::vector<TrialTruth> truths{hidden(1, "surface", "adhesion"),
                                 hidden(2, "elastic", "strain-stiffening"),
                                 hidden(3, "surface", "adhesion")};
  std::vector<TrialOutcome> outcomes{said(1, "family", "surface"), said(2, "family", "elastic"),
                                     said(3, "missing", "surface", "adhesion")};
  outcomes[0].said.candidates = {{"pull-curves", "clipping"}};
  outcomes[1].said.candidates = {{"elastic-curve"}};
  const TrialScores scores = score_trials(trials_of(outcomes, truths));
  EXPECT_EQ(gate(scores, "name right or in the set").share.count, 2);
  EXPECT_EQ(gate(scores, "the same, by a formula and no free form").share.count, 1);
  EXPECT_EQ(gate(scores, "confidently wrong name").share.count, 0);
}

TEST(TrialScoreTest, WhatCouldBeToldApartIsCountedByItself) {
  TrialTruth unlike = hidden(1, "memory", "relaxation"), like = hidden(2, "memory", "relaxation");
  unlike.nearest_family = 0.5;
  unlike.nearest_name = 0.95;
  like.nearest_family = 0.95;
  const TrialScores scores = score_trials(
      trials_of({said(1, "family", "memory"), said(2, "family", "rate"), said(3, "family", "rate")},
                {unlike, like, hidden(3, "memory", "relaxation")}));
  const Share family = gate(scores, "family right, unlike all other families").share;
  EXPECT_EQ(family.count, 1);
  EXPECT_EQ(family.of, 1) << "where a rival is like it, or none is known, nobody could tell";
  EXPECT_EQ(gate(scores, "name right or in the set, unlike all other names").share.of, 0);
}

TEST(TrialScoreTest, ControlsAreScoredByTheSameRules) {
  TrialOutcome first = said(1, "agrees"), second = said(2, "missing", "memory", "relaxation");
  first.controls["random"] = answer_of_set({"force-exponent"}, "elastic");
  second.controls["random"] = answer_of_set({"relaxation"}, "memory");
  second.controls["sparse-regression"] = answer_of_set({"linear-dashpot"}, "rate");
  const TrialScores scores = score_trials(
      trials_of({first, second}, {nothing_hidden(1), hidden(2, "memory", "relaxation")}));
  const auto& random = scores.controls.at("random");
  EXPECT_EQ(gate(random, "false alarms on nulls").share.count, 1);
  EXPECT_EQ(gate(random, "name right or in the set").share.count, 1);
  EXPECT_EQ(gate(scores.controls.at("sparse-regression"), "confidently wrong name").share.count, 1);
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.count, 0);
}

TEST(TrialScoreTest, PowerIsCountedByTheSizeOfTheEffect) {
  const TrialScores scores = score_trials(
      trials_of({said(1, "agrees"), said(2, "agrees"), said(3, "family", "memory"),
                 said(4, "missing", "memory", "relaxation"), said(5, "agrees")},
                {nothing_hidden(1), hidden(2, "memory", "relaxation", 10.0),
                 hidden(3, "memory", "relaxation", 30.0), hidden(4, "memory", "relaxation", 5e5),
                 hidden(5, "memory", "relaxation", 31.0)}));
  ASSERT_EQ(scores.rates.front().by, "visible_chi_square");
  const auto& rows = scores.rates.front().rows;
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].detected.of, 1);
  EXPECT_EQ(rows[0].detected.count, 0);
  EXPECT_EQ(rows[1].detected.of, 2);
  EXPECT_EQ(rows[1].detected.count, 1);
  EXPECT_EQ(rows[1].name_right.count, 0);
  EXPECT_EQ(rows[2].name_right.count, 1);
  EXPECT_LT(rows[1].low, rows[2].low);
  const RateTable& noise = scores.rates[1];
  ASSERT_EQ(noise.rows.size(), 1u);
  EXPECT_EQ(noise.rows[0].label, "1");
  EXPECT_EQ(noise.rows[0].detected.of, 3) << "those that show";
  EXPECT_EQ(noise.rows[0].false_alarm.of, 1);
}

TEST(TrialScoreTest, AtBestARivalDecides) {
  EXPECT_EQ(chance_of_family_at_best(1e4, 1.0), 0.0);
  EXPECT_NEAR(chance_of_family_at_best(6.0, 0.0), 0.5, 1e-12);
  EXPECT_NEAR(chance_of_family_at_best(25.0, 0.0), 0.97128, 1e-5);  // Φ(1.9)
  EXPECT_NEAR(chance_of_family_at_best(100.0, std::sqrt(0.75)), 0.97128, 1e-5);
}

TEST(TrialScoreTest, TheBestIsAnAverageOverEffectsWithAKnownRival) {
  TrialTruth known = hidden(1, "memory", "relaxation", 30.0);
  known.nearest_family = std::sqrt(1.0 - 6.0 / 30.0);
  const TrialScores scores = score_trials(trials_of(
      {said(1, "agrees"), said(2, "agrees")}, {known, hidden(2, "memory", "relaxation", 31.0)}));
  EXPECT_NEAR(scores.rates.front().rows.front().family_at_best.value(), 0.5, 1e-9);
}

TEST(TrialScoreTest, APageAndATextAreMadeOfAnyScores) {
  const TrialScores nulls = score_trials(trials_of({said(1, "agrees")}, {nothing_hidden(1)}));
  const TrialScores effects = score_trials(
      trials_of({said(1, "agrees"), said(2, "missing", "memory", "relaxation")},
                {hidden(1, "memory", "relaxation", 10.0), hidden(2, "memory", "relaxation")}));
  for (const TrialScores* scores : {&nulls, &effects}) {
    EXPECT_NO_THROW(report::check_report(trial_report(*scores)));
    EXPECT_NE(to_text(*scores).find("sparse regression"), std::string::npos);
  }
  EXPECT_EQ(to_json(effects)["rates"]["visible_chi_square"]["rows"][1]["detected"]["count"], 1);
}

TEST(TrialScoreTest, TrialsWithoutTheirTruthsAreRefused) {
  EXPECT_EQ(testing::refusal_of([] { records_of({said(1, "agrees")}, {}); }).code(),
            ExitCode::corrupt_store);
  EXPECT_EQ(
      testing::refusal_of([] { records_of({said(1, "agrees")}, {nothing_hidden(2)}); }).code(),
      ExitCode::corrupt_store);
}

TEST(TrialTruthTest, ATruthThatWasChangedIsRefused) {
  const testing::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "truth");
  const std::string text =
      R"({"set": "example", "seed": 7, "trial": 1, "visible_chi_square": 0.0, "effects": [],
          "noise": {"colour": "white", "stated": "right",
                    "share_of_smallest_baseline_peak": 0.01}})";
  std::ofstream(folder.path() / "truth" / "0001.json") << text;
  std::ofstream(folder.path() / "sealed.txt") << sha256(text) << "  truth/0001.json\n";
  ASSERT_EQ(read_truths(folder.path()).size(), 1u);
  EXPECT_EQ(read_truths(folder.path()).front().seed, 7u);
  std::ofstream(folder.path() / "truth" / "0001.json") << text << "\n";
  EXPECT_EQ(testing::refusal_of([&] { read_truths(folder.path()); }).code(),
            ExitCode::corrupt_store);
}

// Of two effects the families are counted as they act: a memory that fades at once is a damper.
TEST(TrialScoreTest, FamiliesOfTwoEffectsAreThoseThatActInACandidate) {
  TrialTruth pair = hidden(1, "rate", "damping-exponent");
  pair.effects.push_back(hidden(1, "dynamics", "plate-compliance").effects.front());
  const auto counted = [&](const std::vector<std::vector<std::string>>& families) {
    TrialOutcome outcome = said(1, "family");
    outcome.said.candidates = {{"relaxation", "plate-compliance"}};
    outcome.said.candidate_families = families;
    const TrialScores scores = score_trials(testing::trials_of({outcome}, {pair}));
    EXPECT_EQ(gate(scores, "two effects: both in a candidate").share.count, 0);
    return gate(scores, "two effects: both families in a candidate").share.count;
  };
  EXPECT_EQ(counted({{"rate", "dynamics"}}), 1);
  EXPECT_EQ(counted({{"dynamics", "dynamics"}}), 0);
  EXPECT_EQ(counted({}), 0) << "by its name relaxation is a memory";
}

}  // namespace
}  // namespace rebound
