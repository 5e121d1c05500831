#include "lumped/integration/force_deflection.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/integration/composed/composed_force_deflection.hpp"
#include "lumped/integration/fast/step_sensitivities.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

/// A stretch of points that lie on one step and one branch.
struct Stretch {
  std::size_t from, to;
  std::size_t step;
  Branch branch;
};

/// Force over deflection from the steps of one impact, with its derivatives.
template <ContactLaw Law, std::size_t Width>
class ForceDeflection {
 public:
  using Point = ForceWithSensitivities<Width>;

  ForceDeflection(const Law& law, const ContactSetup& setup, const std::array<Direction, Width>& by)
      : setup_(setup), run_(law, setup, by) {
    run_.integrate();
    const auto step_ends = run_.step_ends();
    steps_.reserve(step_ends.size());
    for (std::size_t k = 0; k + 1 < step_ends.size(); ++k) steps_.emplace_back(law, run_, k, by);
    while (step_ends[turn_ + 1].v > 0.0) ++turn_;
    const Septic& root = steps_[turn_].root();
    double low = 0.0, high = 1.0;  // bisection for v = 0: robust, and done once
    for (int i = 0; i < 54; ++i) {
      const double middle = 0.5 * (low + high);
      (root.derivative(middle) > 0.0 ? low : high) = middle;
    }
    turning_fraction_ = low;
    turning_ = root.value(low);
  }

  /// `slopes` has one row a point of `count` columns; empty for Width = 0.
  void fill(const DeflectionPoints& points, std::size_t count, std::span<double> force,
            std::span<double> slopes) const {
    const std::size_t size = points.deflection.size();
    std::vector<double> root(size), fraction(size);
    for (std::size_t i = 0; i < size; ++i) root[i] = std::sqrt(std::max(0.0, points.deflection[i]));
    const auto put = [&](std::size_t i, const Point& point, const auto& slope_of) {
      force[i] = point.force.force;
      for (std::size_t j = 0; j < count; ++j) slopes[i * count + j] = slope_of(point, j);
    };
    for (std::size_t i = 0; i < size;) {
      if (!within(root[i], points.branch[i])) {
        const bool top = root[i] >= turning_;
        put(i, outside(root[i], points.branch[i]), [&](const Point& p, std::size_t j) {
          return top ? p.at_fixed_tau(j) - p.force.by_speed * p.dv[j] : at_open_end(p, j);
        });
        ++i;
        continue;
      }
      const Stretch stretch = stretch_from(i, root, points.branch);
      invert(stretch, root, fraction);
      for (; i < stretch.to; ++i)
        put(i, steps_[stretch.step].at(fraction[i]),
            [&](const Point& p, std::size_t j) { return p.at_fixed_deflection(j, setup_.mass); });
    }
  }

 private:
  const StepEnd& open_end(Branch branch) const {
    return branch == Branch::loading ? run_.step_ends().front() : run_.step_ends().back();
  }
  bool within(double u, Branch branch) const { return u < turning_ && u > open_end(branch).u; }
  Point outside(double u, Branch branch) const {
    if (u >= turning_) return steps_[turn_].at(turning_fraction_);
    return branch == Branch::loading ? steps_.front().at(0.0) : steps_.back().at(1.0);
  }
  /// Where the force is zero it stays so; at x = 0 only the speed there moves.
  double at_open_end(const Point& point, std::size_t direction) const {
    const bool at_zero_force = point.v < 0.0 && !run_.ended_at_zero_deflection();
    return at_zero_force ? 0.0 : point.force.by_speed * point.dv[direction] + point.by[direction];
  }

  std::size_t step_of(double u, Branch branch) const {
    const auto step_ends = run_.step_ends();
    if (branch == Branch::loading) {
      std::size_t k = 0;
      while (k < turn_ && step_ends[k + 1].u <= u) ++k;
      return k;
    }
    std::size_t k = step_ends.size() - 2;
    while (k > turn_ && step_ends[k].u <= u) --k;
    return k;
  }
  bool on_step(double u, const Stretch& stretch) const {
    const double left = run_.step_ends()[stretch.step].u,
                 right = run_.step_ends()[stretch.step + 1].u;
    if (stretch.step == turn_)
      return u < turning_ && u > (stretch.branch == Branch::loading ? left : right);
    return u > std::min(left, right) && u <= std::max(left, right);
  }
  Stretch stretch_from(std::size_t i, const std::vector<double>& root,
                       const std::vector<Branch>& branch) const {
    Stretch stretch{i, i + 1, step_of(root[i], branch[i]), branch[i]};
    while (stretch.to < root.size() && branch[stretch.to] == stretch.branch &&
           on_step(root[stretch.to], stretch))
      ++stretch.to;
    return stretch;
  }

  /// Where u(θ) = √x on one step: from the parabola that shares its ends and the slope of one
  /// of them, three Newton steps reach rounding.
  void invert(const Stretch& stretch, const std::vector<double>& root,
              std::vector<double>& fraction) const {
    const Septic path = steps_[stretch.step].root();
    const StepEnd &left = run_.step_ends()[stretch.step],
                  &right = run_.step_ends()[stretch.step + 1];
    const double* const u = root.data();
    double* const s = fraction.data();
    if (stretch.step == turn_) {
      const bool loading = stretch.branch == Branch::loading;
      const double top = turning_, at = turning_fraction_;
      const double reach = loading ? -at : 1.0 - at;
      const double fall = 1.0 / (top - (loading ? left.u : right.u));
      for (std::size_t i = stretch.from; i < stretch.to; ++i)
        s[i] = at + reach * std::sqrt(std::abs(top - u[i]) * fall);
    } else {
      // From the end that is farther from the turning point, where the slope is larger.
      const bool forward = stretch.branch == Branch::loading;
      const double from = forward ? left.u : right.u, to = forward ? right.u : left.u;
      const double slope = left.step * std::abs(forward ? left.v : right.v);
      const double bend = to - from - slope;
      for (std::size_t i = stretch.from; i < stretch.to; ++i) {
        const double rise = u[i] - from;
        const double along =
            2.0 * rise / (slope + std::sqrt(std::abs(slope * slope + 4.0 * bend * rise)));
        s[i] = forward ? along : 1.0 - along;
      }
    }
    for (int iteration = 0; iteration < 3; ++iteration)
      for (std::size_t i = stretch.from; i < stretch.to; ++i) {
        const double rate = path.derivative(s[i]);
        const double change = (u[i] - path.value(s[i])) / (rate == 0.0 ? 1.0 : rate);
        s[i] = std::min(1.0, std::max(0.0, s[i] + change));
      }
  }

  ContactSetup setup_;
  FastIntegrator<Law, Width> run_;
  std::vector<StepWithSensitivities<Law, Width>> steps_;
  std::size_t turn_ = 0;  ///< the step that contains the turning point
  double turning_fraction_ = 0.0;
  double turning_ = 0.0;  ///< √x there
};

}  // namespace

DeflectionPoints deflection_points(const Trace& trace) {
  const auto& x = trace.deflection;
  const auto peak = std::max_element(x.begin(), x.end()) - x.begin();
  DeflectionPoints points{x, std::vector<Branch>(x.size(), Branch::unloading)};
  std::fill_n(points.branch.begin(), std::min<std::ptrdiff_t>(peak + 1, std::ssize(x)),
              Branch::loading);
  return points;
}

std::vector<double> forces_at(const LumpedProblem& problem, const DeflectionPoints& points) {
  if (ComposedContact::needed(problem)) return composed_forces_at(problem, points);
  const ContactSetup setup = checked_setup(problem);
  std::vector<double> forces(points.deflection.size());
  visit_stateless(
      [&]<class Law>(const Law& law) {
        ForceDeflection<Law, 0>(law, setup, {}).fill(points, 0, forces, {});
      },
      make_law(problem.model, problem.impact, problem.sphere));
  return forces;
}

ForcesWithSensitivities forces_with_sensitivities_at(const LumpedProblem& problem,
                                                     const DeflectionPoints& points,
                                                     std::span<const Direction> by) {
  require_bare(problem);
  const ContactSetup setup = checked_setup(problem);
  ForcesWithSensitivities forces{std::vector<double>(points.deflection.size()),
                                 std::vector<double>(points.deflection.size() * by.size())};
  visit_stateless(
      [&]<class Law>(const Law& law) {
        with_width(by, [&]<std::size_t Width>(const std::array<Direction, Width>& filled) {
          ForceDeflection<Law, Width>(law, setup, filled)
              .fill(points, by.size(), forces.force, forces.slopes);
        });
      },
      make_law(problem.model, problem.impact, problem.sphere));
  return forces;
}

}  // namespace rebound
