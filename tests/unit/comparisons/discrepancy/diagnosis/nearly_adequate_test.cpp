// A curve that is nearly adequate against sets that fit worse.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/candidates.hpp"

namespace rebound {
namespace {

using Members = std::vector<std::size_t>;

AssessedFit fit_of(const std::vector<std::string>& effects, double criterion) {
  AssessedFit one;
  for (const std::string& name : effects) one.fit.effects.push_back({.name = name});
  one.fit.chi_square = one.fit.information_criterion = criterion;
  one.judged = true;
  return one;
}

/// The candidates when a nearly adequate curve stands beside an adequate pair.
Members candidates_beside(double curve, double pair) {
  std::vector<AssessedFit> tried{fit_of({"unloading-curve"}, curve),
                                 fit_of({"hysteresis", "clipping"}, pair)};
  tried[0].nearly_adequate = true;
  tried[1].adequate = true;
  Members members{1};
  prefer_nearly_adequate_curves(tried, 0, 6.0, members);
  return members;
}

TEST(NearlyAdequateTest, ACurveGoesBeforeASetThatFitsPlainlyWorse) {
  EXPECT_EQ(candidates_beside(1000.0, 1110.0), (Members{0}));
}

TEST(NearlyAdequateTest, ASetWithinReachStaysTheCandidate) {
  EXPECT_EQ(candidates_beside(1000.0, 1005.0), (Members{1}));
}

}  // namespace
}  // namespace rebound
