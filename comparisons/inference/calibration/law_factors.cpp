#include "comparisons/inference/calibration/law_factors.hpp"

#include <cmath>

#include "lumped/laws/laws.hpp"

namespace rebound {

LawFactors::LawFactors(LumpedModel believed, const std::vector<Ball>& balls,
                       std::vector<CalibrationParameter>& unknowns)
    : believed_(std::move(believed)) {
  constexpr double reach = 3.0;  // a factor of twenty either way
  const LawCard& card = find_law(believed_.law);
  const bool by_formula = !believed_.damping_formula.empty();
  for (const ParameterCard& parameter : card.parameters)
    if (!parameter.default_value && !(by_formula && parameter.name == card.damping_parameter))
      parameters_.push_back(parameter.name);
  for (const Ball& ball : balls) {
    auto& own = places_.emplace_back();
    for (const auto& name : parameters_) {
      own.push_back(unknowns.size());
      unknowns.push_back({.name = balls.size() > 1 ? name + " of " + ball.name : name,
                          .unit = "ln of factor",
                          .start = 0.0,
                          .lowest = -reach,
                          .highest = reach,
                          .scale = 1.0});
    }
  }
}

LumpedModel LawFactors::at(const std::vector<double>& values, std::size_t ball) const {
  LumpedModel model = believed_;
  for (std::size_t p = 0; p < parameters_.size(); ++p) {
    const double factor = std::exp(values[places_[ball][p]]);
    const auto scale = [&](ParameterValues& numbers) {
      if (const auto found = numbers.find(parameters_[p]); found != numbers.end())
        found->second *= factor;
    };
    scale(model.parameters);
    for (auto& entry : model.at_speed) scale(entry.parameters);
  }
  return model;
}

}  // namespace rebound
