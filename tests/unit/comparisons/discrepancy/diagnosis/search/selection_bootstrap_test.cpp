#include "comparisons/discrepancy/diagnosis/search/selection_bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rebound {
namespace {

constexpr Eigen::Index rows = 50;
constexpr int draws = 4000;

BootstrapCandidate candidate(double distance, double penalty) {
  BootstrapCandidate one{.residuals = Eigen::VectorXd::Constant(rows, 0.3),
                         .basis = Eigen::MatrixXd(rows, 0),
                         .penalty = penalty};
  one.residuals[7] += distance;
  return one;
}

double normal_below(double z) {
  return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

TEST(SelectionBootstrapTest, TwoCandidatesAsOftenAsANormalNumberSays) {
  for (const double d : {0.5, 2.0, 4.0}) {
    const auto shares = chosen_shares({candidate(0.0, 3.0), candidate(d, 3.0)}, 0, rows, draws, 1);
    const double expected = normal_below(-0.5 * d);
    EXPECT_NEAR(shares[1], expected, 4.0 * std::sqrt(expected * (1.0 - expected) / draws)) << d;
    EXPECT_DOUBLE_EQ(shares[0] + shares[1], 1.0);
  }
}

/// A candidate with a further unknown that takes up row 7 follows the noise there: its χ² is
/// smaller by a square of a normal number, against which its penalty stands.
TEST(SelectionBootstrapTest, AFurtherUnknownIsChosenAsOftenAsItsPenaltyAllows) {
  BootstrapCandidate larger = candidate(0.0, 4.0);
  larger.basis = Eigen::MatrixXd::Zero(rows, 1);
  larger.basis(7, 0) = 1.0;
  larger.residuals[7] = 0.0;
  BootstrapCandidate smaller = larger;
  smaller.basis = Eigen::MatrixXd(rows, 0);
  smaller.penalty = 0.0;
  const auto shares = chosen_shares({smaller, larger}, 0, rows, draws, 2);
  const double expected = 2.0 * normal_below(-2.0);  // of |ε| > 2
  EXPECT_NEAR(shares[1], expected, 4.0 * std::sqrt(expected * (1.0 - expected) / draws));
}

TEST(SelectionBootstrapTest, TheSameSeedGivesTheSameShares) {
  const std::vector<BootstrapCandidate> both{candidate(0.0, 1.0), candidate(1.0, 1.0)};
  EXPECT_EQ(chosen_shares(both, 0, rows, 500, 3), chosen_shares(both, 0, rows, 500, 3));
  EXPECT_NE(chosen_shares(both, 0, rows, 500, 3), chosen_shares(both, 0, rows, 500, 4));
}

TEST(SelectionBootstrapTest, InclusionSumsOverTheSetsThatHoldAnEffect) {
  const SelectionBootstrap bootstrap{
      .draws = 100, .chosen = {{{"a"}, 0.5}, {{"a", "b"}, 0.3}, {{"c"}, 0.15}, {{}, 0.05}}};
  EXPECT_DOUBLE_EQ(bootstrap.inclusion("a"), 0.8);
  EXPECT_DOUBLE_EQ(bootstrap.inclusion("b"), 0.3);
  EXPECT_DOUBLE_EQ(bootstrap.inclusion("d"), 0.0);
}

}  // namespace
}  // namespace rebound
