// What a reader of a diagnosis sees first.
#include "comparisons/discrepancy/diagnosis/diagnosis_report.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/diagnosis_tables.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis_text.hpp"
#include "comparisons/discrepancy/diagnosis/shot_pictures.hpp"
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

}  // namespace
}  // namespace rebound
