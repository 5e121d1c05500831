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
  const std::optional<Refitted> found = by(effect);
  if (!found) return std::nullopt;
  return data_.around->project(found->change).squaredNorm();
}

std::optional<Refitted> RefittedChange::by(const EffectChoice& effect) const {
  constexpr int steps = 6;
  constexpr double settled = 1e-2;  // in χ²
  const std::optional<Eigen::VectorXd> change = unfitted(effect);
  const HypothesisFit& fit = *data_.fit;
  if (!change) return std::nullopt;
  if (fit.model->fem()) return Refitted{*change, fit.values};
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
      values = next;
      if (gained < settled) break;
    } catch (const Error& error) {
      if (!has_no_answer(error)) throw;
      break;
    }
  }
  return Refitted{-left, std::move(values)};
}

Eigen::MatrixXd RefittedChange::columns_at(const std::vector<double>& values) const {
  const auto& before = data_.around->all();
  Eigen::MatrixXd columns(std::ssize(data_.fit->residuals), std::ssize(before));
  HypothesisFit moved = *data_.fit;
  moved.model = std::make_shared<const JointModel>(*data_.seen, moved.hypothesis);
  moved.values = values;
  moved.residuals = moved.model->residuals(values);
  const EffectSensitivities around(*data_.seen, moved, data_.around->effects());
  for (std::size_t j = 0; j < before.size(); ++j) {
    const auto same =
        std::find_if(around.all().begin(), around.all().end(), [&](const EffectSensitivity& one) {
          return one.effect.name == before[j].effect.name &&
                 one.effect.size == before[j].effect.size &&
                 one.effect.parameters == before[j].effect.parameters;
        });
    columns.col(static_cast<Eigen::Index>(j)) =
        same == around.all().end() ? before[j].sensitivity : same->sensitivity;
  }
  return columns;
}

}  // namespace rebound
