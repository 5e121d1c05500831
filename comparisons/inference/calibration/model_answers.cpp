#include "comparisons/inference/calibration/model_answers.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {

ModelAnswers::ModelAnswers(const CalibrationProblem& problem)
    : problem_(problem), edge_(problem.parameters.size(), false) {}

bool ModelAnswers::ask(const std::vector<double>& y, std::size_t rows, const Model& model,
                       std::vector<double>& answer) {
  if (failure_) return false;
  std::vector<double> x(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) x[i] = y[i] * problem_.parameters[i].scale;
  ++count_;
  bool found = false;
  try {
    answer = model(x);
    if (answer.size() != rows)
      throw Error(ExitCode::bad_input, "the number of residuals changed with the parameters");
    found = std::all_of(answer.begin(), answer.end(), [](double r) { return std::isfinite(r); });
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) failure_ = std::current_exception();
  } catch (...) {
    failure_ = std::current_exception();
  }
  if (!found) met_no_answer_ = true;
  return found;
}

bool ModelAnswers::difference(std::vector<double>& y, std::size_t j, const Model& model,
                              const std::vector<double>& centre, std::vector<double>& slope) {
  const auto& parameter = problem_.parameters[j];
  const double step = problem_.controls.relative_step, here = y[j];
  std::vector<double> above, below;
  const auto side = [&](double at, std::vector<double>& out) {
    if (at * parameter.scale > parameter.highest || at * parameter.scale < parameter.lowest)
      return false;
    y[j] = at;
    const bool found = ask(y, centre.size(), model, out);
    y[j] = here;
    if (!found) edge_[j] = true;
    return found;
  };
  const bool has_above = side(here + step, above);
  const bool enough = has_above && problem_.controls.differences == Differences::one_sided;
  const bool has_below = !enough && side(here - step, below);
  if (!has_above && !has_below) return false;
  const auto& high = has_above ? above : centre;
  const auto& low = has_below ? below : centre;
  const double width = step * ((has_above ? 1.0 : 0.0) + (has_below ? 1.0 : 0.0));
  slope.resize(centre.size());
  for (std::size_t i = 0; i < centre.size(); ++i) slope[i] = (high[i] - low[i]) / width;
  return true;
}

}  // namespace rebound
