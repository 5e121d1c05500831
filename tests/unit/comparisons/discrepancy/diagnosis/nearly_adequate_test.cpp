// What is nearly adequate, or only fits plainly better, against what is adequate and fits worse.
#include <gtest/gtest.h>

#include "comparisons/discrepancy/diagnosis/search/candidates.hpp"

namespace rebound {
namespace {

using Members = std::vector<std::size_t>;

AssessedFit fit_of(const std::vector<std::string>& effects, double criterion) {
  AssessedFit one;
  for (const std::string& name : effects) one.fit.effects.push_back({.name = name});
  one.fit.chi_square = one.fit.information_criterion = one.fit.prediction_criterion = criterion;
  one.judged = true;
  return one;
}

/// The candidates when a nearly adequate single effect leads adequate ones by so much.
Members candidates_behind(const std::string& leader, const std::vector<std::string>& other,
                          double behind) {
  std::vector<AssessedFit> tried{fit_of({leader}, 1000.0), fit_of(other, 1000.0 + behind)};
  tried[0].nearly_adequate = true;
  tried[1].adequate = true;
  Members members{1};
  prefer_nearly_adequate(tried, 0, 6.0, members);
  return members;
}

TEST(NearlyAdequateTest, ACurveGoesBeforeASetThatFitsPlainlyWorse) {
  EXPECT_EQ(candidates_behind("unloading-curve", {"hysteresis", "clipping"}, 110.0), (Members{0}));
}

TEST(NearlyAdequateTest, ASetWithinReachStaysTheCandidate) {
  EXPECT_EQ(candidates_behind("unloading-curve", {"hysteresis", "clipping"}, 5.0), (Members{1}));
}

TEST(NearlyAdequateTest, SoDoesAFormula) {
  EXPECT_EQ(candidates_behind("sensor-lag", {"linear-dashpot"}, 33.0), (Members{0}));
}

TEST(NearlyAdequateTest, AFormulaThatLeadsStandsBesideASingleWithinReach) {
  EXPECT_EQ(candidates_behind("plate-compliance", {"internal-mode"}, 3.0), (Members{0, 1}));
}

TEST(NearlyAdequateTest, OneThatDoesNotLeadIsNone) {
  EXPECT_EQ(candidates_behind("plate-compliance", {"internal-mode"}, -1.0), (Members{1}));
}

TEST(NearlyAdequateTest, NeitherIsOneBesideASet) {
  EXPECT_EQ(candidates_behind("plate-compliance", {"internal-mode", "adhesion"}, 3.0),
            (Members{1}));
}

/// Is a nearly adequate set that leads by so much, where nothing is adequate, accepted?
bool is_accepted(const std::vector<std::string>& set, double lead) {
  std::vector<AssessedFit> tried{fit_of(set, 1000.0), fit_of({"hysteresis"}, 1000.0 + lead)};
  tried[0].nearly_adequate = true;
  Members members;
  const bool accepted = accept_leading_pair(tried, 0, 6.0, members);
  EXPECT_EQ(members, accepted ? Members{0} : Members{});
  EXPECT_EQ(tried[0].adequate, accepted);
  return accepted;
}

TEST(LeadingPairTest, ACurveBesideAFormulaIsAcceptedWhereAllElseFitsPlainlyWorse) {
  EXPECT_TRUE(is_accepted({"linear-dashpot", "pull-curves"}, 31.0));
  EXPECT_FALSE(is_accepted({"linear-dashpot", "pull-curves"}, 29.0));
}

TEST(LeadingPairTest, FormulasAndSinglesAreNot) {
  EXPECT_FALSE(is_accepted({"linear-dashpot", "adhesion"}, 1000.0));
  EXPECT_FALSE(is_accepted({"pull-curves"}, 1000.0));
  EXPECT_FALSE(is_accepted({"plate-compliance", "linear-dashpot", "pull-curves"}, 1000.0));
}

TEST(LeadingPairTest, NothingIsAcceptedBesideACandidate) {
  std::vector<AssessedFit> tried{fit_of({"linear-dashpot", "pull-curves"}, 1000.0),
                                 fit_of({"hysteresis"}, 2000.0)};
  tried[0].nearly_adequate = tried[1].adequate = true;
  Members members{1};
  EXPECT_FALSE(accept_leading_pair(tried, 0, 6.0, members));
  EXPECT_EQ(members, (Members{1}));
}

/// Fits of these criteria: one that leaves something, and one that is adequate.
std::vector<AssessedFit> leader_and_adequate(const std::string& adequate, double behind, double p) {
  std::vector<AssessedFit> tried{fit_of({"permanent-set"}, 1000.0),
                                 fit_of({adequate}, 1000.0 + behind)};
  tried[0].p_value = p;
  tried[1].p_value = 0.5;
  tried[1].adequate = true;
  return tried;
}

TEST(LeaderTest, FitsPlainlyBetterAndNoiseCouldMakeItsChiSquare) {
  const auto tried = leader_and_adequate("damping-curves", 124.0, 0.17);
  EXPECT_EQ(leader_over_adequate(tried, 6.0, 1e-3), &tried[0]);
}

TEST(LeaderTest, IsNoneWithinReach) {
  EXPECT_EQ(leader_over_adequate(leader_and_adequate("damping-curves", 5.0, 0.17), 6.0, 1e-3),
            nullptr);
}

// Few numbers make a leader by ln N of all samples that what is adequate, with more, outdoes.
TEST(LeaderTest, IsNoneThatPredictsNoBetter) {
  auto tried = leader_and_adequate("damping-curves", 12.0, 0.17);
  EXPECT_EQ(leader_over_adequate(tried, 6.0, 1e-3), &tried[0]);
  tried[1].fit.prediction_criterion = 990.0;
  EXPECT_EQ(leader_over_adequate(tried, 6.0, 1e-3), nullptr);
}

TEST(LeaderTest, IsNoneThatItsOwnChiSquareRefuses) {
  EXPECT_EQ(leader_over_adequate(leader_and_adequate("damping-curves", 124.0, 1e-4), 6.0, 1e-3),
            nullptr);
}

TEST(LeaderTest, DeniesWhatIsOfAnotherFamily) {
  Members members{1};
  deny_other_families_than_leader(leader_and_adequate("damping-curves", 124.0, 0.17), 0, 6.0, 1e-3,
                                  members);
  EXPECT_TRUE(members.empty());
}

// Loading and unloading by a curve each, behind one curve that leaves a little: a second ball.
TEST(LeaderTest, ManyNumbersBehindFewerExplainNothing) {
  const auto left = [](const std::string& adequate, double behind, double p) {
    Members members{1};
    drop_many_numbers_behind_fewer(leader_and_adequate(adequate, behind, p), 6.0, 1e-3, members);
    return members;
  };
  EXPECT_TRUE(left("loading-and-unloading-curves", 12.0, 0.17).empty());
  EXPECT_EQ(left("loading-and-unloading-curves", 5.0, 0.17), (Members{1}));
  EXPECT_EQ(left("loading-and-unloading-curves", 12.0, 1e-4), (Members{1}));
  EXPECT_EQ(left("unloading-curve", 12.0, 0.17), (Members{1}));
}

TEST(LeaderTest, LeavesItsOwnFamily) {
  Members members{1};
  deny_other_families_than_leader(leader_and_adequate("unloading-curve", 124.0, 0.17), 0, 6.0, 1e-3,
                                  members);
  EXPECT_EQ(members, (Members{1}));
}

}  // namespace
}  // namespace rebound
