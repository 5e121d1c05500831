#include "comparisons/discrepancy/trials/sparse_regression.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <numeric>
#include <random>

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

struct Regression {
  Eigen::MatrixXd terms;
  Eigen::VectorXd noise;
};

/// Normal noise of unit variance and eight terms of 400 rows.
Regression random_regression(unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(engine); };
  return {Eigen::MatrixXd::NullaryExpr(400, 8, draw), Eigen::VectorXd::NullaryExpr(400, draw)};
}

std::vector<Eigen::Index> all_of(const Eigen::MatrixXd& terms) {
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(terms.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

TEST(SparseRegressionTest, WithoutAThresholdItIsLeastSquares) {
  const auto [terms, noise] = random_regression(1);
  std::vector<Eigen::Index> kept = all_of(terms);
  const Eigen::VectorXd expected = terms.colPivHouseholderQr().solve(noise);
  EXPECT_LT((thresholded_least_squares(terms, noise, 0.0, kept) - expected).norm(),
            1e-12 * expected.norm());
  EXPECT_EQ(kept.size(), 8u);
}

TEST(SparseRegressionTest, AThresholdAboveAllLeavesNothing) {
  const auto [terms, noise] = random_regression(2);
  std::vector<Eigen::Index> kept = all_of(terms);
  EXPECT_EQ(thresholded_least_squares(terms, noise, 1e6, kept).norm(), 0.0);
  EXPECT_TRUE(kept.empty());
}

TEST(SparseRegressionTest, FindsTheTermsThatAreThereAndNoOthers) {
  int exact = 0, none = 0;
  constexpr int seeds = 40;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    const auto [terms, noise] = random_regression(100 + seed);
    const Eigen::VectorXd found =
        sparse_coefficients(terms, 0.5 * terms.col(2) - 0.8 * terms.col(5) + noise);
    exact += (found.array() != 0.0).count() == 2 && found[2] > 0.0 && found[5] < 0.0;
    none += sparse_coefficients(terms, noise).norm() == 0.0;
  }
  // BIC takes one of six (eight) idle terms of 400 rows with P = 6 (8) × 0.014.
  EXPECT_GE(exact, 32);
  EXPECT_GE(none, 31);
}

EffectFamily family_regressed(std::vector<EffectChoice> effects, int seed) {
  const SynthesisFile file = testing::experiment_with(std::move(effects), seed);
  const Observations seen = observe({synthesize(file, simulator_of(file, {})).dataset});
  const Hypothesis believed{
      .believed = testing::believed_law(), .effects = {}, .model_discrepancy = nullptr};
  return regress_residual_force(seen, fit_believed(seen, believed, {})).family;
}

TEST(SparseRegressionTest, SaysTheFamilyOfPlainEffectsAndNothingOfNulls) {
  constexpr int seeds = 6;
  int elastic = 0, rate = 0, null = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    elastic += family_regressed({{"force-exponent", 0.15, {}}}, 30 + seed) == EffectFamily::elastic;
    rate += family_regressed({{"linear-dashpot", 20.0, {}}}, 30 + seed) == EffectFamily::rate;
    null += family_regressed({}, 30 + seed) == EffectFamily::none;
  }
  EXPECT_GE(elastic, 5);
  EXPECT_GE(rate, 5);
  EXPECT_GE(null, 5);
}

}  // namespace
}  // namespace rebound
