#include "lumped/integration/composed/composed_force_deflection.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "lumped/integration/composed/composed_integrator.hpp"

namespace rebound {

namespace {

template <class Function>
double root_within(const Function& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low * at_high >= 0.0)  // a root at an end, but for rounding
    return std::abs(at_low) < std::abs(at_high) ? low : high;
  std::uintmax_t iterations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(40), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// The steps of a contact as a curve of force over centre-of-mass deflection,
/// which rises to its largest value and falls again.
class ComposedCurve {
 public:
  ComposedCurve(const ComposedContact& contact, const std::vector<ComposedStepEnd>& step_ends)
      : contact_(contact), step_ends_count_(step_ends) {
    const auto turns = [](const ComposedStepEnd& step_end) {
      return velocity(step_end, 1.0) <= 0.0;
    };
    const auto found = std::find_if(step_ends_count_.begin(), step_ends_count_.end() - 1, turns);
    turn_ = static_cast<std::size_t>(found - step_ends_count_.begin());
    turn_fraction_ =
        root_within([&](double s) { return velocity(step_ends_count_[turn_], s); }, 0.0, 1.0);
    largest_ = deflection(step_ends_count_[turn_], turn_fraction_);
  }

  double force(double x, Branch branch) const {
    const ComposedStepEnd& turning = step_ends_count_[turn_];
    if (x >= largest_) return force_in(turning, turn_fraction_);
    const bool loading = branch == Branch::loading;
    if (loading && x <= deflection(step_ends_count_.front(), 0.0))
      return force_in(step_ends_count_.front(), 0.0);
    if (!loading && x <= deflection(step_ends_count_.back(), 1.0))
      return force_in(step_ends_count_.back(), 1.0);
    std::size_t k = loading ? 0 : turn_;
    if (loading)
      while (k < turn_ && deflection(step_ends_count_[k], 1.0) <= x) ++k;
    else
      while (k + 1 < step_ends_count_.size() && deflection(step_ends_count_[k], 1.0) > x) ++k;
    const double from = !loading && k == turn_ ? turn_fraction_ : 0.0;
    const double to = loading && k == turn_ ? turn_fraction_ : 1.0;
    const ComposedStepEnd& step_end = step_ends_count_[k];
    return force_in(step_end,
                    root_within([&](double s) { return deflection(step_end, s) - x; }, from, to));
  }

 private:
  static double velocity(const ComposedStepEnd& step_end, double fraction) {
    return state_within(step_end, fraction)[ComposedContact::velocity];
  }
  double deflection(const ComposedStepEnd& step_end, double fraction) const {
    return contact_.centre_of_mass_deflection(step_end.phase, state_within(step_end, fraction));
  }
  double force_in(const ComposedStepEnd& step_end, double fraction) const {
    return contact_.instrument_force(step_end.phase, state_within(step_end, fraction));
  }

  const ComposedContact& contact_;
  const std::vector<ComposedStepEnd>& step_ends_count_;
  std::size_t turn_ = 0;        ///< the step within which the centre of mass turns
  double turn_fraction_ = 0.0;  ///< where in it
  double largest_ = 0.0;        ///< deflection there [m]
};

}  // namespace

std::vector<double> composed_forces_at(const LumpedProblem& problem,
                                       const DeflectionPoints& points) {
  const ComposedContact contact(problem);
  ComposedIntegrator integrator(contact);
  integrator.integrate();
  const ComposedCurve curve(contact, integrator.step_ends());
  std::vector<double> forces(points.deflection.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = curve.force(points.deflection[i], points.branch[i]);
  return forces;
}

}  // namespace rebound
