#include "comparisons/inference/calibration/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/inference/calibration/search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// The calibration with one parameter held.
class Held {
 public:
  Held(const CalibrationProblem& problem, std::size_t held, std::vector<double> start)
      : whole_(problem), held_(held), rest_(std::move(start)) {
    rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(held));
    inner_ = problem;
    inner_.parameters.erase(inner_.parameters.begin() + static_cast<std::ptrdiff_t>(held));
    inner_.residuals = [this](const std::vector<double>& x) { return whole_.residuals(with(x)); };
    if (!whole_.with_jacobian) return;
    inner_.with_jacobian = [this](const std::vector<double>& x) {
      return without_held(whole_.with_jacobian(with(x)));
    };
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  /// Least cost with the parameter at `value`, from where the last one was
  /// found; infinite where the model has no answer.
  double cost_at(double value, const RunControl& control) {
    value_ = value;
    try {
      const std::vector<double> r = inner_.residuals(rest_);
      if (rest_.empty()) return half_square(r);
      CalibrationCost cost(inner_, static_cast<int>(r.size()));
      std::vector<double> y = rest_;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] /= inner_.parameters[i].scale;
      const Attempt found = search_from(std::move(y), inner_, cost, control);
      if (found.interrupted)
        throw Error(ExitCode::interrupted, "the calibration was interrupted before it ended");
      for (std::size_t i = 0; i < rest_.size(); ++i)
        rest_[i] = found.y[i] * inner_.parameters[i].scale;
      return found.cost;
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
      return std::numeric_limits<double>::infinity();
    }
  }

 private:
  static double half_square(const std::vector<double>& r) {
    double sum = 0.0;
    for (double one : r) sum += 0.5 * one * one;
    return sum;
  }
  ResidualsWithJacobian without_held(ResidualsWithJacobian all) const {
    const std::size_t unknowns = whole_.parameters.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.slopes.size(); ++i)
      if (i % unknowns != held_) all.slopes[kept++] = all.slopes[i];
    all.slopes.resize(kept);
    return all;
  }
  std::vector<double> with(const std::vector<double>& x) const {
    std::vector<double> all = x;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(held_), value_);
    return all;
  }

  const CalibrationProblem& whole_;
  CalibrationProblem inner_;
  std::size_t held_;
  double value_ = 0.0;
  std::vector<double> rest_;
};

struct Point {
  double value = 0.0;
  double cost = 0.0;
};

/// One side of the profile.
struct Side {
  std::optional<double> crossing;  ///< absent: the bound came first
  std::vector<Point> points;
};

Side walk(Held& held, const Point& best, double step, double bound, double allowed,
          const RunControl& control) {
  const double wanted = std::sqrt(allowed);
  const double tolerance = 1e-3 * wanted;
  Side side;
  double inside = best.value, inside_root = 0.0, outside = bound, outside_root = -1.0;
  double at = best.value + step;
  for (int i = 0; i < 40; ++i) {
    const bool beyond = step > 0.0 ? at >= bound : at <= bound;
    if (beyond) at = bound;
    const double cost = held.cost_at(at, control);
    if (std::isfinite(cost)) side.points.push_back({at, cost});
    const double root = std::sqrt(std::max(0.0, 2.0 * (cost - best.cost)));
    if (std::abs(root - wanted) <= tolerance) {
      side.crossing = at;
      return side;
    }
    if (root < wanted) {
      if (beyond) return side;
      inside = at;
      inside_root = root;
    } else {
      outside = at;
      outside_root = root;
    }
    if (outside_root < 0.0) {  // outwards, at most doubling the distance twice
      const double slope = inside_root / (inside - best.value);
      const double reach = slope == 0.0 ? 4.0 * (inside - best.value) : wanted / slope;
      const double limit = 4.0 * (inside - best.value);
      at = best.value + (std::abs(reach) < std::abs(limit) ? 1.05 * reach : limit);
    } else if (!std::isfinite(outside_root)) {
      at = 0.5 * (inside + outside);
    } else {
      const double share = (wanted - inside_root) / (outside_root - inside_root);
      at = inside + std::clamp(share, 0.05, 0.95) * (outside - inside);
    }
    if (std::abs(outside - inside) < 1e-9 * std::abs(bound - best.value)) break;
  }
  if (outside_root >= 0.0) side.crossing = 0.5 * (inside + outside);
  return side;
}

}  // namespace

double allowed_cost_increase(const CalibrationProblem& problem, const CalibrationResult& result,
                             std::size_t residuals) {
  const double level = problem.controls.confidence;
  if (problem.noise == NoiseKnowledge::known) return chi_squared_quantile(1.0, level);
  const double freedom = std::max(
      1.0, static_cast<double>(residuals) - static_cast<double>(problem.parameters.size()));
  return 2.0 * result.cost_after / freedom * fisher_quantile(1.0, freedom, level);
}

ProfileInterval profile_of(const CalibrationProblem& problem, const CalibrationResult& result,
                           std::size_t parameter, const RunControl& control) {
  const auto& card = problem.parameters[parameter];
  const Estimate& estimate = result.estimates[parameter];
  std::vector<double> optimum;
  for (const auto& e : result.estimates) optimum.push_back(e.value);
  const std::size_t residuals = problem.residuals(optimum).size();
  const double allowed = allowed_cost_increase(problem, result, residuals);
  const double width = card.highest - card.lowest;
  double step = 2.0 * estimate.standard_error;
  if (!(step > 0.0) || !std::isfinite(step)) step = 0.1 * card.scale;
  step = std::min(step, 0.5 * width);

  const Point best{estimate.value, result.cost_after};
  ProfileInterval interval{.low = card.lowest, .high = card.highest};
  std::vector<Point> points = {best};
  for (const double sign : {-1.0, 1.0}) {
    Held held(problem, parameter, optimum);
    const double bound = sign < 0.0 ? card.lowest : card.highest;
    if (std::abs(bound - best.value) <= 1e-9 * width) continue;
    const Side side = walk(held, best, sign * step, bound, allowed, control);
    points.insert(points.end(), side.points.begin(), side.points.end());
    if (!side.crossing) continue;
    (sign < 0.0 ? interval.low : interval.high) = *side.crossing;
    (sign < 0.0 ? interval.low_closed : interval.high_closed) = true;
  }
  std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.value < b.value; });
  for (const auto& point : points) {
    interval.value.push_back(point.value);
    interval.cost.push_back(point.cost);
  }
  return interval;
}

}  // namespace rebound
