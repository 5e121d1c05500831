#include "lumped/integration/force_deflection.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/composed_force_deflection.hpp"
#include "lumped/integration/fast_integrator.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

/// Inverts u(θ) = target on a monotone piece by Newton. Started from the outer
/// end of the branch: u is concave while the force pushes, so that the
/// iteration never jumps over the turning point.
double solve(const Septic& root, double target, double start) {
  double s = start;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double rate = root.derivative(s);
    if (rate == 0.0) break;
    const double change = (target - root.value(s)) / rate;
    s = std::clamp(s + change, 0.0, 1.0);
    if (std::abs(change) < 1e-13) break;
  }
  return s;
}

template <ContactLaw Law>
class ForceDeflection {
 public:
  ForceDeflection(const Law& law, std::span<const Knot> knots) : law_(law), knots_(knots) {
    while (knots_[turn_ + 1].v > 0.0) ++turn_;
    const Septic root = piece(turn_);
    double low = 0.0, high = 1.0;  // bisection for v = 0: robust, and done once
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (root.derivative(middle) > 0.0 ? low : high) = middle;
    }
    turning_ = root.value(low);
  }

  double force(double deflection, Branch branch) const {
    const double u = std::sqrt(std::max(0.0, deflection));
    if (u >= turning_) return law_.force(turning_ * turning_, 0.0);
    const bool loading = branch == Branch::loading;
    const Knot& outer = loading ? knots_.front() : knots_.back();
    if (u <= outer.u) return law_.force(outer.u * outer.u, outer.v);
    const std::size_t k = loading ? loading_piece(u) : unloading_piece(u);
    const Septic root = piece(k);
    const double s = solve(root, u, loading ? 0.0 : 1.0);
    return law_.force(u * u, root.derivative(s) / knots_[k].step);
  }

 private:
  Septic piece(std::size_t k) const {
    return {knots_[k].root(), knots_[k + 1].root(), knots_[k].step};
  }
  std::size_t loading_piece(double u) const {
    const auto first = knots_.begin(), last = first + static_cast<std::ptrdiff_t>(turn_) + 1;
    const auto above =
        std::upper_bound(first, last, u, [](double value, const Knot& k) { return value < k.u; });
    return static_cast<std::size_t>(above - first) - 1;
  }
  std::size_t unloading_piece(double u) const {
    const auto first = knots_.begin() + static_cast<std::ptrdiff_t>(turn_) + 1;
    const auto below = std::lower_bound(first, knots_.end(), u,
                                        [](const Knot& k, double value) { return k.u > value; });
    return static_cast<std::size_t>(below - knots_.begin()) - 1;
  }

  const Law& law_;
  std::span<const Knot> knots_;
  std::size_t turn_ = 0;  ///< the step that contains the turning point
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
  if (problem.model.mechanisms.act()) return composed_forces_at(problem, points);
  const ContactSetup setup = checked_setup(problem);
  std::vector<double> forces(points.deflection.size());
  std::visit(
      [&]<class Law>(const Law& law) {
        FastIntegrator<Law> integrator(law, setup);
        integrator.integrate();
        const ForceDeflection<Law> curve(law, integrator.knots());
        for (std::size_t i = 0; i < forces.size(); ++i)
          forces[i] = curve.force(points.deflection[i], points.branch[i]);
      },
      make_law(problem.model, problem.impact, problem.sphere));
  return forces;
}

}  // namespace rebound
