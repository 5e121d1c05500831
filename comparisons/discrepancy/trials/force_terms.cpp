#include "comparisons/discrepancy/trials/force_terms.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/laws/make_law.hpp"

namespace rebound {
namespace {

double sign_of(double v) {
  return v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0);
}

/// Slopes of the law along an impact.
struct SlopesAlong {
  std::vector<double> by_deflection, by_rate;
};

SlopesAlong slopes_along(const LumpedProblem& problem, const Trace& impact,
                         const std::vector<double>& rates) {
  const AnyLaw law = make_law(problem.model, problem.impact, problem.sphere);
  const double largest = *std::max_element(impact.deflection.begin(), impact.deflection.end());
  constexpr double smallest_share = 1e-9;  // ∂F/∂x of a law like √x has no value at first touch
  SlopesAlong slopes;
  for (std::size_t i = 0; i < impact.time.size(); ++i) {
    const double x = std::max(impact.deflection[i], smallest_share * largest);
    const ForceSlopes at =
        std::visit([&](const auto& one) { return one.at_root(std::sqrt(x), rates[i]); }, law);
    slopes.by_deflection.push_back(at.by_log_deflection / x);
    slopes.by_rate.push_back(at.by_speed);
  }
  return slopes;
}

}  // namespace

const std::vector<ForceTerm>& force_terms() {
  using F = EffectFamily;
  static const std::vector<ForceTerm> terms{
      {"1", F::measurement, [](double, double) { return 1.0; }, false},
      {"1 in contact", F::surface, [](double, double) { return 1.0; }, true},
      {"x", F::elastic, [](double x, double) { return x; }, true},
      {"x^1.5", F::elastic, [](double x, double) { return x * std::sqrt(x); }, true},
      {"x^2", F::elastic, [](double x, double) { return x * x; }, true},
      {"x^3", F::elastic, [](double x, double) { return x * x * x; }, true},
      {"v", F::rate, [](double, double v) { return v; }, true},
      {"sqrt(x) v", F::rate, [](double x, double v) { return std::sqrt(x) * v; }, true},
      {"x v", F::rate, [](double x, double v) { return x * v; }, true},
      {"v |v|", F::rate, [](double, double v) { return v * std::abs(v); }, true},
      {"sign(v)", F::history, [](double, double v) { return sign_of(v); }, true},
      {"x sign(v)", F::history, [](double x, double v) { return x * sign_of(v); }, true},
  };
  return terms;
}

std::vector<double> deflection_rates(const Trace& impact) {
  const std::size_t count = impact.time.size();
  std::vector<double> rates(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, count - 1);
    rates[i] = (impact.deflection[after] - impact.deflection[before]) /
               (impact.time[after] - impact.time[before]);
  }
  return rates;
}

std::vector<double> force_response(const ForceTerm& term, const LumpedProblem& problem,
                                   const Trace& impact, const MotionScales& scales) {
  const std::vector<double> rates = deflection_rates(impact);
  const SlopesAlong slopes = slopes_along(problem, impact, rates);
  const double mass = problem.sphere.mass;
  double dx = 0.0, dv = 0.0;  // of a change by one newton of the term
  const auto change = [&](std::size_t i, double x, double v) {
    const double deflection = std::max(0.0, impact.deflection[i]) / scales.deflection;
    return term.at(deflection, rates[i] / scales.rate) + slopes.by_deflection[i] * x +
           slopes.by_rate[i] * v;
  };
  std::vector<double> response{change(0, dx, dv)};
  for (std::size_t i = 1; i < impact.time.size(); ++i) {
    const double h = impact.time[i] - impact.time[i - 1];
    const double a = -response.back() / mass;
    const double b = -change(i, dx + h * dv, dv + h * a) / mass;
    dx += h * (dv + 0.5 * h * a);
    dv += 0.5 * h * (a + b);
    response.push_back(change(i, dx, dv));
  }
  return response;
}

}  // namespace rebound
