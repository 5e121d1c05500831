// Balls in finite elements: scored apart from those that obey a law, and against what is asked
// there.
#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/discrepancy/trials/trial_report.hpp"
#include "comparisons/discrepancy/trials/trial_score.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "comparisons/io/report/check.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

using testing::gate;
using testing::hidden;
using testing::nothing_hidden;
using testing::said;
using testing::trials_of;

TEST(TrialScoreInFemTest, BallsInFiniteElementsAreScoredByThemselves) {
  const auto of_a_body = [](TrialTruth truth, const std::string& ball = "foam") {
    truth.ball = ball;
    return truth;
  };
  const TrialScores scores = score_trials(trials_of(
      {said(1, "agrees"), said(2, "one-of"), said(3, "agrees"),
       said(4, "missing", "memory", "relaxation"), said(5, "missing", "memory", "relaxation"),
       said(6, "family", "elastic")},
      {nothing_hidden(1), of_a_body(nothing_hidden(2)), of_a_body(nothing_hidden(3), "rubber"),
       of_a_body(hidden(4, "memory", "relaxation")), of_a_body(hidden(5, "history", "hysteresis")),
       of_a_body(hidden(6, "elastic", "foam-softening"))}));
  EXPECT_EQ(scores.trials, 1);
  EXPECT_EQ(gate(scores, "false alarms on nulls").share.of, 1);
  EXPECT_EQ(gate(scores, "family right").share.of, 0);
  EXPECT_TRUE(scores.false_alarms_by_ball.empty());
  ASSERT_NE(scores.in_fem, nullptr);
  const TrialScores& in_fem = *scores.in_fem;
  EXPECT_EQ(in_fem.trials, 5);
  EXPECT_EQ(gate(in_fem, "false alarms on nulls").share.count, 1);
  EXPECT_EQ(gate(in_fem, "false alarms on nulls").share.of, 2);
  EXPECT_EQ(in_fem.false_alarms_by_ball.at("foam").count, 1);
  EXPECT_EQ(in_fem.false_alarms_by_ball.at("rubber").count, 0);
  EXPECT_EQ(gate(in_fem, "family right").share.count, 2);
  EXPECT_EQ(gate(in_fem, "family right").share.of, 3);
  EXPECT_EQ(gate(in_fem, "wrong family").share.count, 1);
  const TrialGate& single = gate(in_fem, "single name right, of those that say one");
  EXPECT_EQ(single.share.count, 1);
  EXPECT_EQ(single.share.of, 2);
  EXPECT_EQ(single.least, 0.85);
  EXPECT_EQ(gate(in_fem, "confidently wrong name").share.count, 1);
  EXPECT_EQ(in_fem.controls.at("random").size(), in_fem.gates.size());

  const Json json = to_json(scores);
  EXPECT_EQ(json.at("trials"), 1);
  EXPECT_EQ(json.at("in_fem").at("trials"), 5);
  EXPECT_EQ(json.at("in_fem").at("false_alarms_by_ball").at("foam").at("of"), 1);
  EXPECT_NE(to_text(scores).find("IN FINITE ELEMENTS"), std::string::npos);
  const report::Report page = trial_report(scores);
  EXPECT_NO_THROW(report::check_report(page));
  EXPECT_EQ(std::count_if(
                page.sections.begin(), page.sections.end(),
                [](const report::Section& one) { return one.title == "Balls in finite elements"; }),
            1);
  EXPECT_EQ(to_json(score_trials(trials_of({said(1, "agrees")}, {nothing_hidden(1)}))).at("in_fem"),
            nullptr);
}

TEST(TrialScoreInFemTest, BallsThatAreBelievedInFiniteElementsAreScoredByThemselves) {
  TrialTruth asked = hidden(1, "memory", "relaxation"), doubted = hidden(2, "memory", "relaxation");
  asked.ball = doubted.ball = "foam";
  doubted.believed = "fem";
  const TrialCollection trials = trials_of(
      {said(1, "unexplained"), said(2, "missing", "memory", "relaxation")}, {asked, doubted});
  const TrialScores scores = score_trials(trials);
  EXPECT_EQ(scores.trials, 0);
  EXPECT_EQ(scores.in_fem->trials, 1);
  EXPECT_EQ(gate(*scores.in_fem, "family right").share.count, 0);
  ASSERT_NE(scores.fem_believed, nullptr);
  EXPECT_EQ(gate(*scores.fem_believed, "family right").share.count, 1);
  EXPECT_EQ(to_json(scores).at("fem_believed").at("trials"), 1);
  EXPECT_EQ(to_json(*scores.in_fem).at("fem_believed"), nullptr);
  EXPECT_NE(to_text(scores).find("FINITE ELEMENTS BELIEVED"), std::string::npos);
  EXPECT_NO_THROW(report::check_report(trial_report(scores)));
}

}  // namespace
}  // namespace rebound
