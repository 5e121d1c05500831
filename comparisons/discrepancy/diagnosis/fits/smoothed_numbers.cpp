#include "comparisons/discrepancy/diagnosis/fits/smoothed_numbers.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace rebound {
namespace {

CostOfNumbers cost_at(const FittedNumbers& numbers, const Eigen::MatrixXd& information,
                      const std::vector<double>& weight) {
  Eigen::MatrixXd penalised = information;
  for (std::size_t i = 0; i < weight.size(); ++i) penalised += weight[i] * numbers.roughness[i];
  const Eigen::LDLT<Eigen::MatrixXd> factors(penalised);
  const Eigen::VectorXd moved = factors.solve(information * numbers.value) - numbers.value;
  Eigen::MatrixXd of_data = information;
  of_data.diagonal() -= numbers.prior;
  return {.numbers = factors.solve(of_data).trace(),
          .lost_chi_square = moved.dot(information * moved)};
}

}  // namespace

CostOfNumbers smoothest(const FittedNumbers& numbers, double each) {
  const Eigen::Index count = numbers.value.size();
  // In units of the errors, in which the inverse is well conditioned.
  const Eigen::VectorXd error = numbers.covariance.diagonal().cwiseSqrt();
  const Eigen::MatrixXd correlation =
      error.cwiseInverse().asDiagonal() * numbers.covariance * error.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd information =
      error.cwiseInverse().asDiagonal() *
      Eigen::MatrixXd(correlation.ldlt().solve(Eigen::MatrixXd::Identity(count, count))) *
      error.cwiseInverse().asDiagonal();
  std::vector<double> weight(numbers.roughness.size(), 0.0);
  CostOfNumbers best = cost_at(numbers, information, weight);
  for (int round = 0; round < 2; ++round)
    for (double& one : weight) {
      double kept = one;
      for (int step = 0; step <= 10; ++step) {
        one = std::pow(10.0, step);
        if (const CostOfNumbers cost = cost_at(numbers, information, weight);
            cost.with(each) < best.with(each)) {
          best = cost;
          kept = one;
        }
      }
      one = kept;
    }
  return best;
}

}  // namespace rebound
