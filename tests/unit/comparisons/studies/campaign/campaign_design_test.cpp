#include "comparisons/studies/campaign/campaign_design.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace rebound {
namespace {

CampaignFactor between(double low, double high, int points = 0) {
  CampaignFactor factor;
  factor.key = "key";
  factor.low = low;
  factor.high = high;
  factor.points = points;
  return factor;
}

CampaignDesign sampled(DesignKind kind, std::int64_t count) {
  return {.kind = kind,
          .count = count,
          .seed = 3,
          .factors = {between(0, 1), between(0, 1)},
          .known = {}};
}

TEST(CampaignDesignTest, AGridTakesTheEndsExactlyAndTurnsTheLastFactorFirst) {
  CampaignFactor speeds = between(1.0, 100.0, 3), cells;
  speeds.spacing = Spacing::logarithmic;
  cells.values = {60, 120};
  const CampaignDesign design{.factors = {speeds, cells}, .known = {}};
  ASSERT_EQ(member_count(design), 6u);
  DesignSampler sampler(design);
  EXPECT_THAT(sampler.at(0), ::testing::ElementsAre(1.0, 60.0));
  EXPECT_THAT(sampler.at(1), ::testing::ElementsAre(1.0, 120.0));
  EXPECT_NEAR(sampler.at(2)[0], 10.0, 1e-12);
  EXPECT_THAT(sampler.at(5), ::testing::ElementsAre(100.0, 120.0));
}

TEST(CampaignDesignTest, EveryCellOfALatinHypercubeHoldsOnePoint) {
  const CampaignDesign design = sampled(DesignKind::latin_hypercube, 101);
  DesignSampler sampler(design);
  std::set<int> first, second;
  int on_diagonal = 0;
  for (std::size_t i = 0; i < 101; ++i) {
    const auto point = sampler.at(i);
    first.insert(static_cast<int>(point[0] * 101.0));
    second.insert(static_cast<int>(point[1] * 101.0));
    on_diagonal += point[0] == point[1];
  }
  EXPECT_EQ(first.size(), 101u);
  EXPECT_EQ(second.size(), 101u);
  EXPECT_LT(on_diagonal, 10);  // the factors have permutations of their own
  CampaignDesign other = design;
  other.seed = 4;
  EXPECT_NE(DesignSampler(other).at(0), DesignSampler(design).at(0));
}

TEST(CampaignDesignTest, SobolPointsFillEveryBinaryIntervalButOne) {
  const CampaignDesign design = sampled(DesignKind::sobol, 63);
  DesignSampler sampler(design);
  for (std::size_t factor = 0; factor < 2; ++factor) {
    std::set<int> intervals;
    for (std::size_t i = 0; i < 63; ++i)
      intervals.insert(static_cast<int>(sampler.at(i)[factor] * 64.0));
    EXPECT_EQ(intervals.size(), 63u);
    EXPECT_FALSE(intervals.contains(0));  // that of the zero point
  }
}

TEST(CampaignDesignTest, AnyPointComesAtAnyTime) {
  for (const DesignKind kind : {DesignKind::latin_hypercube, DesignKind::sobol}) {
    const CampaignDesign design = sampled(kind, 1000);
    DesignSampler forwards(design), backwards(design);
    std::vector<std::vector<double>> points;
    for (std::size_t i = 0; i < 1000; ++i) points.push_back(forwards.at(i));
    for (std::size_t i = 1000; i-- > 0;) EXPECT_EQ(backwards.at(i), points[i]);
  }
}

TEST(CampaignDesignTest, ListedValuesAreSampledEvenly) {
  CampaignDesign design = sampled(DesignKind::latin_hypercube, 30);
  design.factors[0] = {};
  design.factors[0].values = {2, 3, 5};
  DesignSampler sampler(design);
  std::multiset<double> taken;
  for (std::size_t i = 0; i < 30; ++i) taken.insert(sampler.at(i)[0]);
  for (const double value : {2.0, 3.0, 5.0}) EXPECT_EQ(taken.count(value), 10u);
}

}  // namespace
}  // namespace rebound
