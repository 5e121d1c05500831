#include "comparisons/inference/calibration/held_parameter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "comparisons/inference/calibration/search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
HeldParameter::HeldParameter(const CalibrationProblem& problem, std::size_t held,
                             std::vector<double> start)
    : whole_(problem), held_(held), start_(std::move(start)) {
  start_.erase(start_.begin() + static_cast<std::ptrdiff_t>(held));
  inner_ = problem;
  inner_.parts.reset();  // their unknowns are those of the whole
  inner_.parameters.erase(inner_.parameters.begin() + static_cast<std::ptrdiff_t>(held));
  inner_.residuals = [this](const std::vector<double>& x) { return whole_.residuals(with(x)); };
  if (!whole_.with_jacobian) return;
  inner_.with_jacobian = [this](const std::vector<double>& x) {
    return without_held(whole_.with_jacobian(with(x)));
  };
}

HeldParameter::Point HeldParameter::point_at(double value, const Point& before, const Point& near,
                                             const RunControl& control) {
  value_ = value;
  Point point{value, std::numeric_limits<double>::infinity(), near.others};
  try {
    const std::vector<double> r = inner_.residuals(point.others);
    if (point.others.empty()) return {value, half_square(r), {}};
    std::vector<double> ahead = on_the_line(value, before, near);
    if (cost_or_infinity(ahead) < half_square(r)) point.others = std::move(ahead);
    CalibrationCost cost(inner_, static_cast<int>(r.size()));
    std::vector<double> y = point.others;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] /= inner_.parameters[i].scale;
    const Attempt found = search_from(std::move(y), inner_, cost, control);
    if (found.interrupted)
      throw Error(ExitCode::interrupted, "the calibration was interrupted before it ended");
    for (std::size_t i = 0; i < point.others.size(); ++i)
      point.others[i] = found.y[i] * inner_.parameters[i].scale;
    point.cost = found.cost;
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
  }
  return point;
}

double HeldParameter::cost_or_infinity(const std::vector<double>& others) const {
  try {
    return half_square(inner_.residuals(others));
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
    return std::numeric_limits<double>::infinity();
  }
}

std::vector<double> HeldParameter::on_the_line(double value, const Point& before,
                                               const Point& near) const {
  if (near.value == before.value) return near.others;
  const double share = (value - near.value) / (near.value - before.value);
  std::vector<double> ahead = near.others;
  for (std::size_t i = 0; i < ahead.size(); ++i)
    ahead[i] = std::clamp(ahead[i] + share * (near.others[i] - before.others[i]),
                          inner_.parameters[i].lowest, inner_.parameters[i].highest);
  return ahead;
}

ResidualsWithJacobian HeldParameter::without_held(ResidualsWithJacobian all) const {
  const std::size_t unknowns = whole_.parameters.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.slopes.size(); ++i)
    if (i % unknowns != held_) all.slopes[kept++] = all.slopes[i];
  all.slopes.resize(kept);
  return all;
}

std::vector<double> HeldParameter::with(const std::vector<double>& others) const {
  std::vector<double> all = others;
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(held_), value_);
  return all;
}

}  // namespace rebound
