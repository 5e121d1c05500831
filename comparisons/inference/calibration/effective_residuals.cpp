#include "comparisons/inference/calibration/effective_residuals.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

double softened(double r, RobustLoss loss, double a) {
  const double s = r / a;
  switch (loss) {
    case RobustLoss::none: return r;
    case RobustLoss::huber:
      return std::abs(s) <= 1.0 ? r : std::copysign(a * std::sqrt(2.0 * std::abs(s) - 1.0), r);
    case RobustLoss::soft_l1: {
      // √(1+s²) − 1 written without cancellation.
      const double grown = s * s / (std::sqrt(1.0 + s * s) + 1.0);
      return std::copysign(a * std::sqrt(2.0 * grown), r);
    }
    case RobustLoss::cauchy: return std::copysign(a * std::sqrt(std::log1p(s * s)), r);
  }
  return r;
}

/// Derivative of the same by r.
double softening(double r, RobustLoss loss, double a) {
  const double s = std::abs(r / a);
  switch (loss) {
    case RobustLoss::none: return 1.0;
    case RobustLoss::huber: return s <= 1.0 ? 1.0 : 1.0 / std::sqrt(2.0 * s - 1.0);
    case RobustLoss::soft_l1: {
      const double root = std::sqrt(1.0 + s * s);
      return std::sqrt(0.5 * (root + 1.0)) / root;  // s/√(2 (root − 1)) over root
    }
    case RobustLoss::cauchy: {
      const double log = std::log1p(s * s);
      return log == 0.0 ? 1.0 : s / ((1.0 + s * s) * std::sqrt(log));
    }
  }
  return 1.0;
}

}  // namespace

void append_priors(const std::vector<CalibrationParameter>& parameters,
                   const std::vector<double>& x, std::vector<double>& residuals) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (const auto& prior = parameters[i].prior)
      residuals.push_back((x[i] - prior->mean) / prior->deviation);
}

CalibrationProblem with_priors(const CalibrationProblem& problem) {
  const auto& parameters = problem.parameters;
  const bool any = std::any_of(parameters.begin(), parameters.end(),
                               [](const auto& p) { return p.prior.has_value(); });
  if (!any) return problem;
  if (problem.noise != NoiseKnowledge::known)
    throw Error(ExitCode::bad_input,
                "a prior can be weighed against data of known noise only: state the force noise");
  for (const auto& p : parameters)
    if (p.prior && !(p.prior->deviation > 0.0))
      throw Error(ExitCode::bad_input, "the prior of '" + p.name + "' has no width",
                  {.key = p.name, .value = std::to_string(p.prior->deviation), .allowed = "> 0"});
  CalibrationProblem whole = problem;
  whole.residuals = [parameters, data = problem.residuals](const std::vector<double>& x) {
    std::vector<double> r = data(x);
    append_priors(parameters, x, r);
    return r;
  };
  if (!problem.with_jacobian) return whole;
  whole.with_jacobian = [parameters, data = problem.with_jacobian](const std::vector<double>& x) {
    ResidualsWithJacobian r = data(x);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (const auto& prior = parameters[i].prior) {
        r.residuals.push_back((x[i] - prior->mean) / prior->deviation);
        r.slopes.resize(r.slopes.size() + parameters.size(), 0.0);
        *(r.slopes.end() - static_cast<std::ptrdiff_t>(parameters.size() - i)) =
            1.0 / prior->deviation;
      }
    return r;
  };
  return whole;
}

CalibrationProblem with_loss(const CalibrationProblem& problem, std::size_t data, double scale) {
  CalibrationProblem softer = problem;
  softer.residuals = [inner = problem.residuals, loss = problem.controls.loss, data,
                      scale](const std::vector<double>& x) {
    std::vector<double> r = inner(x);
    for (std::size_t i = 0; i < std::min(data, r.size()); ++i) r[i] = softened(r[i], loss, scale);
    return r;
  };
  if (!problem.with_jacobian) return softer;
  softer.with_jacobian = [inner = problem.with_jacobian, loss = problem.controls.loss, data,
                          scale](const std::vector<double>& x) {
    ResidualsWithJacobian r = inner(x);
    const std::size_t unknowns = x.size();
    for (std::size_t i = 0; i < std::min(data, r.residuals.size()); ++i) {
      const double factor = softening(r.residuals[i], loss, scale);
      for (std::size_t j = 0; j < unknowns; ++j) r.slopes[i * unknowns + j] *= factor;
      r.residuals[i] = softened(r.residuals[i], loss, scale);
    }
    return r;
  };
  return softer;
}

double robust_deviation(std::vector<double> residuals) {
  for (double& r : residuals) r = std::abs(r);
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  return 1.4826 * *middle;
}

}  // namespace rebound
