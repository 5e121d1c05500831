// What slow compressions say beside the impacts of their ball: a part of JointModel.
#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/discrepancy/diagnosis/fits/static_force.hpp"

namespace rebound {

void JointModel::add_slow_factors() {
  constexpr double reach = 4.6;  // a factor of a hundred
  std::map<std::size_t, std::size_t> of_balls;
  for (std::size_t k = 0; k < seen_.compressions.size(); ++k) {
    const SlowCompression& test = seen_.compressions[k];
    const bool is_hit = std::any_of(seen_.shots.begin(), seen_.shots.end(),
                                    [&](const MeasuredImpact& s) { return s.ball == test.ball; });
    if (test.compared_only || !is_hit) continue;
    const bool is_first = !of_balls.contains(test.ball);
    if (is_first) {
      of_balls[test.ball] = unknowns_.size();
      unknowns_.push_back({.name = "slow over impact stiffness of " + seen_.balls[test.ball].name,
                           .unit = "ln of factor",
                           .start = 0.0,
                           .lowest = -reach,
                           .highest = reach,
                           .scale = 1.0});
    }
    slow_factors_[k] = of_balls[test.ball];
    for (std::size_t i = 0; i < test.force.size() + (is_first ? 1 : 0); ++i)
      rows_.push_back({seen_.shots.size() + k, ObservedQuantity::quasistatic, 0.0});
  }
}

std::vector<double> JointModel::slow_block_at(const std::vector<double>& values,
                                              std::size_t k) const {
  constexpr double as_good_as_one = 0.05;
  const SlowCompression& test = seen_.compressions[k];
  std::size_t shot = 0;
  while (seen_.shots[shot].ball != test.ball) ++shot;
  const LumpedProblem problem = problem_at(values, shot);
  const int believed = chain_at(values, shot).platens;
  const int contacts = believed > 0 ? believed : test.platens;
  const std::size_t unknown = slow_factors_.at(k);
  std::vector<double> rows;
  for (std::size_t i = 0; i < test.force.size(); ++i)
    rows.push_back((std::exp(values[unknown]) *
                        static_force(problem, test.deflection[i] / contacts, test.duration) -
                    test.force[i]) /
                   test.error[i]);
  const bool is_first = std::none_of(slow_factors_.begin(), slow_factors_.find(k),
                                     [&](const auto& one) { return one.second == unknown; });
  if (!is_first) return rows;
  const double departure = values[unknown] / as_good_as_one;
  const auto all = static_cast<double>(rows_.size());
  rows.push_back(departure / std::sqrt(1.0 + departure * departure / std::log(all)));
  return rows;
}

std::vector<double> JointModel::slow_rows_at(const std::vector<double>& values) const {
  std::vector<double> rows;
  for (const auto& [test, unknown] : slow_factors_) {
    const std::vector<double> block = slow_block_at(values, test);
    rows.insert(rows.end(), block.begin(), block.end());
  }
  return rows;
}

}  // namespace rebound
