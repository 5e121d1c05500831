#include "comparisons/discrepancy/design/refitted_change.hpp"

#include <algorithm>
#include <utility>

#include "comparisons/discrepancy/design/linear_rows.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Eigen::VectorXd residuals_of(const JointModel& model, const std::vector<double>& values) {
  const std::vector<double> residuals = model.residuals(values);
  return Eigen::Map<const Eigen::VectorXd>(residuals.data(), std::ssize(residuals));
}

bool has_no_answer(const Error& error) {
  return error.code() == ExitCode::bad_input || error.code() == ExitCode::solver_failed;
}

}  // namespace

RefittedChange::RefittedChange(const PlannedData& data)
    : data_(data), jacobian_(free_jacobian(*data.fit)) {}

std::optional<Eigen::VectorXd> RefittedChange::unfitted(const EffectChoice& effect) const {
  const HypothesisFit& fit = *data_.fit;
  Hypothesis with = fit.hypothesis;
  with.effects.push_back(effect);
  try {
    const JointModel model(*fit.model, fit.values, with);
    const Eigen::VectorXd moved = residuals_of(model, values_from(fit, model));
    return moved - Eigen::Map<const Eigen::VectorXd>(fit.residuals.data(), moved.size());
  } catch (const Error& error) {
    if (!has_no_answer(error)) throw;
    return std::nullopt;
  }
}

std::optional<double> RefittedChange::rise(const EffectChoice& effect) const {
  const std::optional<Eigen::VectorXd> left = by(effect);
  if (!left) return std::nullopt;
  return data_.around->project(*left).squaredNorm();
}

std::optional<Eigen::VectorXd> RefittedChange::by(const EffectChoice& effect) const {
  constexpr int steps = 6;
  constexpr double settled = 1e-2;  // in χ²
  std::optional<Eigen::VectorXd> change = unfitted(effect);
  const HypothesisFit& fit = *data_.fit;
  if (!change || fit.model->fem()) return change;
  const JointModel model(*data_.seen, fit.hypothesis);  // of this thread
  const Eigen::VectorXd before = residuals_of(model, fit.values);
  std::vector<double> values = fit.values;
  Eigen::VectorXd left = -*change;
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd step = jacobian_.solve(left);
    std::vector<double> next = values;
    for (std::size_t k = 0; k < next.size(); ++k) {
      const CalibrationParameter& unknown = model.unknowns()[k];
      next[k] =
          std::clamp(next[k] - step[static_cast<Eigen::Index>(k)], unknown.lowest, unknown.highest);
    }
    try {
      const Eigen::VectorXd moved = residuals_of(model, next) - before - *change;
      const double gained = left.squaredNorm() - moved.squaredNorm();
      if (gained <= 0.0) break;
      left = moved;
      values = std::move(next);
      if (gained < settled) break;
    } catch (const Error& error) {
      if (!has_no_answer(error)) throw;
      break;
    }
  }
  return -left;
}

}  // namespace rebound
