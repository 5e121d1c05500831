// What a reader of a diagnosis sees first.
#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_answers.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_json.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_tables.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/discrepancy/diagnosis/output/shot_pictures.hpp"
#include "fem/interface/elastic_models.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::diagnose_hidden;
using testing::experiment_with;

const report::Series* series_of(const report::Figure& figure, const std::string& name) {
  for (const report::Series& one : figure.series)
    if (one.name == name) return &one;
  return nullptr;
}

TEST(DiagnosisReportTest, TheFirstScreenHoldsNumbersWithUnitsAndTheGapAtTheUnseenSpeed) {
  const Diagnosis d =
      diagnose_hidden(experiment_with({{.name = "relaxation", .size = 0.5, .parameters = {}}}, 9));
  ASSERT_EQ(d.verdict, DiagnosisVerdict::missing);
  const report::Report page = diagnosis_report(d, "hidden", {});
  const auto* sentence = std::get_if<report::Paragraph>(&page.lead.front());
  ASSERT_NE(sentence, nullptr);
  EXPECT_NE(sentence->text.find("relaxation time "), std::string::npos) << sentence->text;
  EXPECT_NE(sentence->text.find(" µs ["), std::string::npos) << sentence->text;
  const auto* figure = std::get_if<report::Figure>(&page.lead.back());
  ASSERT_NE(figure, nullptr);
  const auto* before = series_of(*figure, "unseen speed, believed model, refitted");
  const auto* after = series_of(*figure, "unseen speed, with what is missing");
  ASSERT_TRUE(before && after);
  ASSERT_EQ(before->x, std::vector<double>{15.0});
  EXPECT_NEAR(before->y[0], *d.gap.held_out_before, 1e-9);
  EXPECT_NEAR(after->y[0], *d.gap.held_out_after, 1e-9);
  EXPECT_EQ(found_table(d).rows.size(), 2u);
  const ShotFigures figures = shot_figures(d);
  EXPECT_EQ(figures.residuals.size(), 3u);
  EXPECT_EQ(figures.histories.size(), 3u);
  EXPECT_NE(figures.residuals.front().title.find("unseen"), std::string::npos);
}

TEST(DiagnosisReportTest, WhereNothingIsMissingOnlyTheBelievedModelIsDrawn) {
  const Diagnosis d = diagnose_hidden(experiment_with({}, 3));
  ASSERT_EQ(d.verdict, DiagnosisVerdict::agrees);
  const report::Figure figure = gap_figure(d);
  EXPECT_EQ(series_of(figure, "with what is missing"), nullptr);
  const auto* before = series_of(figure, "believed model, refitted");
  ASSERT_NE(before, nullptr);
  EXPECT_EQ(before->x.size(), 2u);
  EXPECT_TRUE(found_table(d).rows.empty());
}

/// A diagnosis of nothing hidden, as if FE had been asked.
Diagnosis with_fem_asked() {
  Diagnosis d = diagnose_hidden(experiment_with({}, 3));
  d.fem_alone = std::make_shared<const ModelDiscrepancy>();
  return d;
}

EffectInFem answer(const std::string& name, const std::string& lumped, const std::string& fem) {
  EffectInFem one;
  one.effect = {.name = name, .size = 0.5, .parameters = {}};
  one.gap = {.before = 9.0, .after = 4.0};
  one.lumped_before = 16.0;
  one.lumped = lumped;
  one.fem = fem;
  return one;
}

/// All that stands on the first screen as text.
std::string lead_of(const Diagnosis& d) {
  std::string text;
  for (const report::Block& block : diagnosis_report(d, "", {}).lead) {
    if (const auto* paragraph = std::get_if<report::Paragraph>(&block)) text += paragraph->text;
    if (const auto* table = std::get_if<report::Table>(&block)) text += table->title;
  }
  return text;
}

// A gap that FE closes has no fit beside the lumped law that could be drawn.
TEST(DiagnosisReportTest, WhatFeFoundIsNotDrawnAsAFitBesideTheLaw) {
  Diagnosis d = testing::diagnose_hidden(testing::experiment_with({}, 3));
  ASSERT_FALSE(d.extended());
  const std::size_t drawn = gap_figure(d).series.size();
  d.gap.after = 1.0;
  EXPECT_EQ(gap_figure(d).series.size(), drawn);
}

/// Where the verdict rests on FE its points stand beside those of the law, by decades where the law
/// is far off.
TEST(DiagnosisReportTest, TheGapInFeIsDrawnShotByShot) {
  Diagnosis d = testing::diagnose_hidden(testing::experiment_with({}, 3));
  const std::size_t of_the_law = gap_figure(d).series.size();
  EXPECT_EQ(gap_figure(d).y.spacing, report::Axis::Spacing::linear);
  ASSERT_EQ(d.seen->shots.size(), 2u);
  ASSERT_EQ(d.unseen->shots.size(), 1u);
  d.shots_in_fem = ShotsInFem{.effect = "adhesion",
                              .without = {},
                              .with = {},
                              .before = {{100, 50.0}, {100, 9.0}},
                              .after = {{100, 1.1}, {}},
                              .unseen_before = {{100, 20.0}},
                              .unseen_after = {{100, 1.2}}};
  const report::Figure figure = gap_figure(d);
  EXPECT_EQ(figure.series.size(), of_the_law + 4);
  const report::Series* before = series_of(figure, "FE with nothing hidden");
  ASSERT_TRUE(before);
  EXPECT_EQ(before->y, (std::vector{50.0, 9.0}));
  EXPECT_EQ(series_of(figure, "FE with adhesion")->y, std::vector{1.1}) << "one was not looked at";
  EXPECT_EQ(series_of(figure, "unseen speed, FE with adhesion")->y, std::vector{1.2});
  EXPECT_EQ(figure.y.spacing, report::Axis::Spacing::logarithmic);
}

TEST(DiagnosisReportTest, OfFeTheFirstScreenSpeaksOnlyWhereFeWasAsked) {
  Diagnosis d = diagnose_hidden(experiment_with({}, 3));
  EXPECT_EQ(fem_sentence(d), "");
  EXPECT_EQ(lead_of(d).find("FE"), std::string::npos);
  d.fem_alone = std::make_shared<const ModelDiscrepancy>();
  EXPECT_NE(lead_of(d).find("FE was asked what a body of finite size does"), std::string::npos);
  EXPECT_EQ(lead_of(d).find("What each tier says"), std::string::npos) << "no effect was asked of";
}

/// Data that a ball of finite size follows are no proof of the law that was believed.
TEST(DiagnosisReportTest, WhereTheLawAloneDoesNotFollowTheDataTheFirstSentenceSaysSo) {
  Diagnosis d = with_fem_asked();
  EXPECT_EQ(headline(d), "Model and data agree within the noise.");
  EXPECT_EQ(to_json(d)["law_alone"], nullptr);
  d.law_alone = Gap{.before = 100.0, .held_out_before = 49.0};
  EXPECT_NE(headline(d).find("ball of finite size with nothing hidden"), std::string::npos);
  EXPECT_NE(headline(d).find("The lumped law alone leaves 10 standard deviations"),
            std::string::npos);
  EXPECT_NE(lead_of(d).find("adds leaves 100, at that speed 49"), std::string::npos) << lead_of(d);
  EXPECT_NE(to_text(d).find("law alone 100, unseen 49"), std::string::npos) << to_text(d);
  EXPECT_EQ(to_json(d)["law_alone"]["gap"], 100.0);
  EXPECT_EQ(to_json(d)["law_alone"]["where"], true) << "no part of FE is in the map";
  d.model_discrepancy = d.fem_alone;
  EXPECT_EQ(to_json(d)["law_alone"]["where"], false);
}

TEST(DiagnosisReportTest, FesOwnBallIsSaidInWords) {
  FittedFem ball;
  ball.material.elastic = ElasticModel::ogden;
  ball.material.youngs_modulus = 12.34e6;
  ball.material.poisson_ratio = 0.42;
  ball.material.branches = {
      {.ratio = 0.5, .relaxation_time = 21e-6},
      {.ratio = 0.25, .relaxation_time = 1.5e-4, .relaxes = Relaxes::deviator}};
  ball.effects = {{.name = "plate-compliance", .size = 2e-9, .parameters = {}}};
  EXPECT_EQ(fem_ball_in_words(ball),
            "ogden, E 12.3 MPa, ν 0.42, branch 0.5 in 21 µs, branch of the deviator 0.25 in 150 "
            "µs, plate-compliance 2e-09 m/N");
  Diagnosis d = with_fem_asked();
  EXPECT_TRUE(fem_balls_in_words(d).empty()) << "none was fitted";
  ModelDiscrepancy fitted;
  ball.samples = 10;
  fitted.balls = {ball};
  d.fem_alone = std::make_shared<const ModelDiscrepancy>(fitted);
  EXPECT_EQ(fem_balls_in_words(d), std::vector{fem_ball_in_words(ball)});
  EXPECT_NE(lead_of(d).find("FE's own ball on the plate that FE has found under it: ogden, E 12.3"),
            std::string::npos);
  fitted.balls.front().effects.clear();
  d.fem_alone = std::make_shared<const ModelDiscrepancy>(fitted);
  EXPECT_NE(lead_of(d).find("FE's own ball with nothing hidden: ogden, E 12.3 MPa"),
            std::string::npos);
}

TEST(DiagnosisReportTest, ANameIsShownWithTheVerdictOfEachTierAndItsGaps) {
  Diagnosis d = with_fem_asked();
  d.in_fem = {answer("relaxation", "supported", "rejected")};
  EXPECT_NE(lead_of(d).find(
                "rejects it, so that the tiers differ: it leaves 3.00 standard deviations without"),
            std::string::npos)
      << lead_of(d);
  EXPECT_NE(lead_of(d).find("What each tier says"), std::string::npos);
  const report::Table table = tiers_table(d);
  ASSERT_EQ(table.rows.size(), 1u);
  ASSERT_EQ(table.rows[0].size(), table.columns.size());
  std::vector<std::string> cells;
  for (const report::TableCell& cell : table.rows[0]) cells.push_back(cell.text);
  EXPECT_EQ(cells, (std::vector<std::string>{"relaxation", "differ", "supported", "rejected",
                                             "4.00 → –", "3.00 → 2.00", "– → –", "0.5"}));
  d.in_fem = std::vector<EffectInFem>(7, answer("relaxation", "supported", "supported"));
  EXPECT_EQ(tiers_table(d).rows.size(), 4u);
  EXPECT_NE(tiers_table(d).caption.find("best 4 of 7"), std::string::npos);
}

TEST(DiagnosisReportTest, TheTiersAgreeDifferOrOneOfThemCannotSay) {
  EXPECT_EQ(tiers_together(answer("relaxation", "supported", "supported")), "agree");
  EXPECT_EQ(tiers_together(answer("relaxation", "rejected", "rejected")), "agree");
  EXPECT_EQ(tiers_together(answer("relaxation", "rejected", "supported")), "differ");
  EXPECT_EQ(tiers_together(answer("relaxation", "supported", "no-fit")), "FE cannot say");
  EXPECT_EQ(tiers_together(answer("hysteresis", "no-form", "supported")), "FE alone");
  EXPECT_EQ(tiers_together(answer("hysteresis", "no-form", "rejected")), "agree");
}

TEST(DiagnosisReportTest, WhereNothingLumpedExplainsTheDataTheAnswerOfFeStandsInASentence) {
  Diagnosis d = with_fem_asked();
  d.fem_with_nothing_hidden = Gap{.before = 9.0};
  EXPECT_NE(fem_sentence(d).find("it leaves 3.00 standard deviations"), std::string::npos);
  EXPECT_NE(fem_sentence(d).find("The tiers differ"), std::string::npos) << "it agrees in FE alone";
  d.verdict = DiagnosisVerdict::unexplained;
  EXPECT_NE(fem_sentence(d).find("No effect of FE came nearer"), std::string::npos);
  d.in_fem = {answer("hysteresis", "no-form", "no-fit")};
  EXPECT_NE(fem_sentence(d).find("hysteresis comes nearest with 2.00"), std::string::npos);
  d.in_fem = {answer("hysteresis", "no-form", "supported")};
  EXPECT_NE(
      fem_sentence(d).find("; with hysteresis FE leaves 2.00. That effect has no lumped form."),
      std::string::npos)
      << fem_sentence(d);
}

}  // namespace
}  // namespace rebound
