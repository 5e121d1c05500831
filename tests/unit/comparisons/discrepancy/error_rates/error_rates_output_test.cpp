// Rates beside a verdict, as they are read.
#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

Diagnosis agreement(double noise_share) {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::agrees;
  d.design = {.speeds = 3, .noise_share = noise_share};
  d.gap.before = 1.0;
  return d;
}

std::string only_paragraph(const Diagnosis& d) {
  const MeasuredErrorRates page = error_rates_on_page(d);
  EXPECT_TRUE(page.sentence.empty());
  if (page.blocks.size() != 1) return "";
  const auto* paragraph = std::get_if<report::Paragraph>(&page.blocks.front());
  return paragraph ? paragraph->text : "";
}

TEST(ErrorRatesOutputTest, AVerdictStandsBesideItsRecord) {
  const Diagnosis d = agreement(0.03);
  EXPECT_NE(error_rates_text(d).find("\"agrees\" said and true: 22 of 24"), std::string::npos);
  const MeasuredErrorRates page = error_rates_on_page(d);
  EXPECT_NE(page.sentence.find("a verdict 'agrees' was true in 22 of 24"), std::string::npos);
  ASSERT_EQ(page.blocks.size(), 1u);
  EXPECT_EQ(std::get<report::Table>(page.blocks.front()).rows.size(), 2u);
}

TEST(ErrorRatesOutputTest, WhereNoTrialIsAlikeThatIsSaid) {
  EXPECT_EQ(error_rates_text(agreement(0.0)), "");
  EXPECT_NE(only_paragraph(agreement(0.0)).find("was not measured"), std::string::npos);
  Diagnosis fem_believed = agreement(0.03);
  fem_believed.numerical_uncertainty = 0.004;
  EXPECT_EQ(error_rates_text(fem_believed), "");
  EXPECT_NE(only_paragraph(fem_believed).find("a lumped law is believed"), std::string::npos);
}

}  // namespace
}  // namespace rebound
