#include "comparisons/inference/calibration/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "comparisons/inference/calibration/distributions.hpp"
#include "comparisons/inference/calibration/held_parameter.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {

namespace {

using Held = HeldParameter;
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
  const std::vector<double> optimum = result.values();
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
