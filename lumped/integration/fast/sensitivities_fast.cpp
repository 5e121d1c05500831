#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/fast/step_sensitivities.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

template <class Function>
double sign_change(const Function& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low * at_high >= 0.0) return std::abs(at_low) < std::abs(at_high) ? low : high;
  std::uintmax_t iterations = 100;
  const auto found = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (found.first + found.second);
}

/// Reads values and derivatives off one integrated impact.
template <ContactLaw Law, std::size_t Width>
class Reading {
 public:
  Reading(const Law& law, const ContactSetup& setup, const std::array<Direction, Width>& by,
          std::size_t count)
      : setup_(setup), run_(law, setup, by) {
    run_.integrate();
    result_.slopes.resize(count);
    for (std::size_t k = 0; k + 1 < run_.step_ends().size(); ++k)
      steps_.emplace_back(law, run_, k, by);
    read_end(by);
    read_peak_deflection();
    read_peak_force();
  }

  Sensitivities sampled(int samples) && {
    const std::size_t count = result_.slopes.size();
    result_.force_slopes.assign(count, {});
    std::size_t k = 0;
    for (int i = 0; i < samples; ++i) {
      const double instant = result_.outcome.contact_time * i / (samples - 1);
      while (k + 1 < steps_.size() && run_.step_ends()[k + 1].t <= instant) ++k;
      const ForceWithSensitivities<Width> point =
          steps_[k].at(fraction_at(run_.step_ends()[k], run_.step_ends()[k + 1], instant));
      result_.time.push_back(instant);
      result_.force.push_back(point.force.force);
      for (std::size_t j = 0; j < count; ++j)
        result_.force_slopes[j].push_back(point.at_fixed_time(j, setup_.mass));
    }
    return std::move(result_);
  }

 private:
  void read_end(const std::array<Direction, Width>& by) {
    const ContactEnd& end = run_.end();
    const ForceWithSensitivities<Width> point = steps_.back().at(1.0);
    result_.outcome.contact_time = end.time;
    result_.outcome.restitution = -end.velocity / setup_.speed;
    for (std::size_t i = 0; i < result_.slopes.size(); ++i) {
      // du/dτ = v, dv/dτ = −2uF/m: at either kind of end the latter is zero.
      const double shift = run_.ended_at_zero_deflection()
                               ? -point.du[i] / point.v
                               : -point.at_fixed_tau(i) / point.rate(setup_.mass);
      const double u_end = std::sqrt(end.deflection);
      result_.slopes[i].contact_time = point.dt[i] + 2.0 * u_end * shift;
      result_.slopes[i].restitution = -point.dv[i] / setup_.speed;
      if (by[i].of == Direction::Of::speed)
        result_.slopes[i].restitution -= result_.outcome.restitution / setup_.speed;
    }
  }

  void read_peak_deflection() {
    std::size_t k = 0;
    while (run_.step_ends()[k + 1].v > 0.0) ++k;
    const double s = sign_change([&](double at) { return steps_[k].at(at).v; }, 0.0, 1.0);
    const ForceWithSensitivities<Width> top = steps_[k].at(s);
    result_.outcome.peak_deflection = top.u * top.u;
    for (std::size_t i = 0; i < result_.slopes.size(); ++i)
      result_.slopes[i].peak_deflection = 2.0 * top.u * top.du[i];
  }

  void read_peak_force() {
    constexpr int parts = 4;  // of a step: the force turns once in a contact
    ForceWithSensitivities<Width> highest = steps_.front().at(0.0);
    for (const auto& step : steps_)
      for (int part = 0; part < parts; ++part) {
        const double low = part / double(parts), high = (part + 1) / double(parts);
        const auto rate = [&](double s) { return step.at(s).rate(setup_.mass); };
        if (!(rate(low) > 0.0 && rate(high) <= 0.0)) continue;
        const ForceWithSensitivities<Width> point = step.at(sign_change(rate, low, high));
        if (point.force.force > highest.force.force) highest = point;
      }
    result_.outcome.peak_force = highest.force.force;
    for (std::size_t i = 0; i < result_.slopes.size(); ++i)
      result_.slopes[i].peak_force = highest.at_fixed_tau(i);
  }

  ContactSetup setup_;
  FastIntegrator<Law, Width> run_;
  std::vector<StepWithSensitivities<Law, Width>> steps_;
  Sensitivities result_;
};

}  // namespace

Sensitivities sensitivities_fast(const LumpedProblem& problem) {
  require_bare(problem);
  const ContactSetup setup = checked_setup(problem);
  const auto by = all_directions(problem.model.law);
  constexpr std::size_t fewest = 3;  // a parameter, mass and speed
  Sensitivities result = visit_stateless(
      [&]<class Law>(const Law& law) {
        return with_width<fewest>(
            by, [&]<std::size_t Width>(const std::array<Direction, Width>& filled) {
              return Reading<Law, Width>(law, setup, filled, by.size())
                  .sampled(problem.controls.samples);
            });
      },
      make_law(problem.model, problem.impact, problem.sphere));
  result.by = names_of_directions(problem.model.law);
  return result;
}

}  // namespace rebound
