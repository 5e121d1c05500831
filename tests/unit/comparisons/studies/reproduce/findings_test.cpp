#include "comparisons/studies/reproduce/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/studies/reproduce/reproduction.hpp"
#include "comparisons/studies/reproduce/wording.hpp"
#include "tests/unit/comparisons/studies/reproduce/whole_reproduction.hpp"

namespace rebound {
namespace {

using testing::whole_reproduction;

const Finding& finding(const std::string& id) {
  const auto found =
      std::find_if(whole_reproduction().findings.begin(), whole_reproduction().findings.end(),
                   [&](const Finding& item) { return item.id == id; });
  if (found == whole_reproduction().findings.end()) throw std::logic_error("no finding " + id);
  return *found;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Values below were computed independently of this program.
TEST(FindingsTest, SpeedsBehindTableThree) {
  EXPECT_TRUE(says(finding("table-3-implied-speeds").evidence, "A 5.49/14.09/24.27"))
      << finding("table-3-implied-speeds").evidence;
}

TEST(FindingsTest, RestitutionThatTheDampingReturns) {
  const std::string& evidence = finding("eq-8-low-loss").evidence;
  EXPECT_TRUE(says(evidence, "A 0.734/0.661/0.639")) << evidence;
  EXPECT_TRUE(says(evidence, "D 0.752/0.671/0.650")) << evidence;
}

TEST(FindingsTest, StiffnessOfOneContact) {
  const Finding& ratio = finding("platens-are-two-contacts");
  EXPECT_TRUE(says(ratio.evidence, "8.6/7.5/7.3/7.0")) << ratio.evidence;
  EXPECT_TRUE(says(ratio.evidence, "3.05/2.66/2.58/2.46")) << ratio.evidence;
  EXPECT_TRUE(says(finding("eq-10-factor").statement, "0.471"));
  EXPECT_TRUE(says(finding("block-against-ball").evidence, "by Hertz 3.97/3.69/7.61/5.13"))
      << finding("block-against-ball").evidence;
}

TEST(FindingsTest, ContactTimeAndLossOverSpeed) {
  const std::string& time = finding("contact-time-over-speed").evidence;
  EXPECT_TRUE(says(time, "measured -0.060/-0.033/-0.139/-0.111")) << time;
  EXPECT_TRUE(says(time, "1.13/1.07/1.32/1.25")) << time;
  EXPECT_TRUE(says(finding("loss-over-speed").evidence, "one λ 1.00"));
}

TEST(FindingsTest, TheOutlyingMeanDeflection) {
  EXPECT_TRUE(says(finding("mean-deflection-core-D-5").statement, "2.40 mm"));
  const auto outliers = std::count_if(
      whole_reproduction().findings.begin(), whole_reproduction().findings.end(),
      [](const Finding& item) { return item.id.starts_with("mean-deflection-core-"); });
  EXPECT_EQ(outliers, 1);
}

TEST(FindingsTest, EquationSevenHoldsOnlyAsDerived) {
  EXPECT_TRUE(says(finding("eq-7-as-printed").evidence, "apart by a share of 1.0000"))
      << finding("eq-7-as-printed").evidence;
}

TEST(FindingsTest, PulseFactorOfTheTypicalPeaks) {
  EXPECT_TRUE(says(finding("pulse-factor").evidence, "A 1.98/2.48/2.70"))
      << finding("pulse-factor").evidence;
}

TEST(FindingsTest, OneDiameterRepairsTableTwo) {
  const Finding& repair = finding("table-2-diameter");
  EXPECT_TRUE(says(repair.statement, "2 of 4 numbers differ")) << repair.statement;
  EXPECT_TRUE(says(repair.evidence, "4 of 4 rows are then met to the digit")) << repair.evidence;
  EXPECT_TRUE(says(repair.evidence, "66.80 mm (core B, to the digit)")) << repair.evidence;
}

TEST(FindingsTest, OneMassRepairsEachCoreOfTableFive) {
  for (const char* core : {"b", "c", "d"})
    EXPECT_NO_THROW(finding(std::string("table-5-core-") + core + "-mass"));
  EXPECT_NO_THROW(finding("table-5-no-single-repair"));
  const Paper changed =
      with_repaired_masses({whole_reproduction().paper, whole_reproduction().runs,
                            whole_reproduction().rows, whole_reproduction().searches});
  EXPECT_EQ(changed.cores[0].mass.value,
            whole_reproduction().paper.cores[0].mass.value);  // core A follows
  EXPECT_NEAR(changed.cores[1].mass.value, 84.4e-3, 0.2e-3);
}

TEST(FindingsTest, NoSingleChangeRepairsTableThree) {
  EXPECT_NO_THROW(finding("table-3-no-single-repair"));
}

TEST(FindingsTest, MeansThatContradictTheirParts) {
  EXPECT_TRUE(
      says(finding("linear-contact-time-mean-contradicts-itself").evidence, "6.18 to 6.28 %"));
  EXPECT_TRUE(says(finding("restitution-mean-contradicts-itself").evidence, "12.52 to 12.62 %"));
}

TEST(WordingTest, SlopeOfAPowerLawIsItsExponent) {
  EXPECT_NEAR(logarithmic_slope({5.0, 15.0, 25.0}, {25.0, 225.0, 625.0}), 2.0, 1e-13);
}

}  // namespace
}  // namespace rebound
