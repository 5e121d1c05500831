#include "comparisons/inference/calibration/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/inference/calibration/search.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// The calibration with one parameter held.
class Held {
 public:
  Held(const CalibrationProblem& problem, std::size_t held, std::vector<double> start)
      : whole_(problem), held_(held), start_(std::move(start)) {
    start_.erase(start_.begin() + static_cast<std::ptrdiff_t>(held));
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

  /// A value that is held, the least cost with it, and where the others stand then.
  struct Point {
    double value = 0.0;
    double cost = 0.0;  ///< infinite where the model has no answer
    std::vector<double> others;
  };
  Point start(double value, double cost) const { return {value, cost, start_}; }

  /// Least cost with the parameter at `value`, the others searched from where they stand at `near`,
  /// or on the line from `before` through it, whichever is the better start.
  Point point_at(double value, const Point& before, const Point& near, const RunControl& control) {
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

 private:
  static double half_square(const std::vector<double>& r) {
    double sum = 0.0;
    for (double one : r) sum += 0.5 * one * one;
    return sum;
  }
  double cost_or_infinity(const std::vector<double>& others) const {
    try {
      return half_square(inner_.residuals(others));
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
      return std::numeric_limits<double>::infinity();
    }
  }
  std::vector<double> on_the_line(double value, const Point& before, const Point& near) const {
    if (near.value == before.value) return near.others;
    const double share = (value - near.value) / (near.value - before.value);
    std::vector<double> ahead = near.others;
    for (std::size_t i = 0; i < ahead.size(); ++i)
      ahead[i] = std::clamp(ahead[i] + share * (near.others[i] - before.others[i]),
                            inner_.parameters[i].lowest, inner_.parameters[i].highest);
    return ahead;
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
  std::vector<double> start_;  ///< the others at the optimum
};

using Point = Held::Point;

/// One side of the profile.
struct Side {
  std::optional<double> crossing;  ///< absent: the bound came first
  std::vector<Point> points;
};

/// Outwards from the optimum until the cost has risen by what is allowed.
///
/// Every search starts from the farthest point inside: one beyond may have left the valley that the
/// others follow. A valley that bends is lost by a long step too, so that a crossing is believed
/// only when its outer end, searched again from beside it, is still outside.
class Walk {
 public:
  Walk(Held& held, const Point& best, double bound, double allowed, const RunControl& control)
      : held_(held),
        best_(best),
        bound_(bound),
        wanted_(std::sqrt(allowed)),
        control_(control),
        inside_(best) {}

  Side from_step(double step) {
    double at = best_.value + step;
    for (int i = 0; i < most_searches; ++i) {
      const bool beyond = step > 0.0 ? at >= bound_ : at <= bound_;
      const Point point = search(beyond ? bound_ : at);
      const double root = root_of(point);
      if (std::abs(root - wanted_) <= 1e-3 * wanted_) return finished(point.value);
      if (root < wanted_) {
        if (beyond) return side_;
        move_inside(point);
      } else {
        outside_ = point;
        lost_before_ = true;
      }
      if (outside_ && std::abs(outside_->value - inside_.value) <= close_) {
        const Point again = search(outside_->value);
        if (root_of(again) >= wanted_) return finished(crossing());
        move_inside(again);
        outside_.reset();
      }
      at = next();
    }
    if (outside_) return finished(crossing());
    return side_;
  }

 private:
  static constexpr int most_searches = 60;

  void move_inside(const Point& point) {
    stride_ = std::abs(point.value - inside_.value);
    inside_ = point;
  }
  Point search(double value) {
    Point point = held_.point_at(value, best_, inside_, control_);
    if (std::isfinite(point.cost)) side_.points.push_back(point);
    return point;
  }
  double root_of(const Point& point) const {
    return std::sqrt(std::max(0.0, 2.0 * (point.cost - best_.cost)));
  }
  Side finished(double crossing) {
    side_.crossing = crossing;
    return std::move(side_);
  }
  /// Where √(2 ΔC) meets what is allowed, by a secant of the two ends.
  double crossing() const {
    const double low = root_of(inside_), high = root_of(*outside_);
    if (!std::isfinite(high)) return 0.5 * (inside_.value + outside_->value);
    return inside_.value + (wanted_ - low) / (high - low) * (outside_->value - inside_.value);
  }
  double next() {
    close_ = 0.02 * std::abs(inside_.value - best_.value) + 1e-6 * std::abs(bound_ - best_.value);
    if (outside_) {
      const double width = outside_->value - inside_.value;
      const double share = (crossing() - inside_.value) / width;
      return inside_.value + std::clamp(share, 0.1, 0.9) * width;
    }
    const double far = inside_.value - best_.value, slope = root_of(inside_) / far;
    const double reach = slope == 0.0 ? 4.0 * far : 1.05 * wanted_ / slope;
    const double limit =
        lost_before_ ? std::abs(far) + 2.0 * stride_ : 4.0 * std::abs(far);  // as the valley bends
    return best_.value + std::copysign(std::min(std::abs(reach), limit), far);
  }

  Held& held_;
  const Point& best_;
  double bound_, wanted_;
  const RunControl& control_;
  Point inside_;
  std::optional<Point> outside_;
  double close_ = 0.0;
  double stride_ = 0.0;       ///< between the last two points inside
  bool lost_before_ = false;  ///< has a step left the valley, or met the end of the interval?
  Side side_;
};

/// One side of the profile, none where the optimum stands at that bound.
Side walk(const CalibrationProblem& problem, const CalibrationResult& result, std::size_t parameter,
          double sign, const RunControl& control) {
  const auto& card = problem.parameters[parameter];
  const Estimate& estimate = result.estimates[parameter];
  std::vector<double> optimum;
  for (const auto& e : result.estimates) optimum.push_back(e.value);
  const double width = card.highest - card.lowest;
  const double bound = sign < 0.0 ? card.lowest : card.highest;
  if (std::abs(bound - estimate.value) <= 1e-9 * width) return {};
  const std::size_t residuals = problem.residuals(optimum).size();
  const double allowed = allowed_cost_increase(problem, result, residuals);
  double step = 2.0 * estimate.standard_error;
  if (!(step > 0.0) || !std::isfinite(step)) step = 0.1 * card.scale;
  step = std::min(step, 0.5 * width);
  Held held(problem, parameter, optimum);
  const Point best = held.start(estimate.value, result.cost_after);
  return Walk(held, best, bound, allowed, control).from_step(sign * step);
}

ProfileInterval interval_of(const CalibrationParameter& card, const CalibrationResult& result,
                            std::size_t parameter, const std::array<Side, 2>& sides) {
  ProfileInterval interval{.low = sides[0].crossing.value_or(card.lowest),
                           .high = sides[1].crossing.value_or(card.highest)};
  interval.low_closed = sides[0].crossing.has_value();
  interval.high_closed = sides[1].crossing.has_value();
  std::vector<Point> points = {{result.estimates[parameter].value, result.cost_after, {}}};
  for (const Side& side : sides)
    points.insert(points.end(), side.points.begin(), side.points.end());
  std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.value < b.value; });
  for (const auto& point : points) {
    interval.value.push_back(point.value);
    interval.cost.push_back(point.cost);
  }
  return interval;
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
  const Side low = walk(problem, result, parameter, -1.0, control);
  return interval_of(problem.parameters[parameter], result, parameter,
                     {low, walk(problem, result, parameter, 1.0, control)});
}

ProfileInterval profile_of(const CalibrationProblem& below, const CalibrationProblem& above,
                           const CalibrationResult& result, std::size_t parameter,
                           const RunControl& control) {
  std::array<Side, 2> sides;
  in_parallel(2, [&](std::size_t i) {
    sides[i] = walk(i == 0 ? below : above, result, parameter, i == 0 ? -1.0 : 1.0, control);
  });
  return interval_of(below.parameters[parameter], result, parameter, sides);
}

}  // namespace rebound
