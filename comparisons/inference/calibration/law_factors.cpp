#include "comparisons/inference/calibration/law_factors.hpp"

#include <cmath>

#include "lumped/laws/laws.hpp"

namespace rebound {

std::vector<std::string> unknown_numbers(const LumpedModel& model) {
  const LawCard& card = find_law(model.law);
  const bool by_formula = !model.damping_formula.empty();
  std::vector<std::string> names;
  for (const ParameterCard& parameter : card.parameters)
    if (!parameter.default_value && !(by_formula && parameter.name == card.damping_parameter))
      names.push_back(parameter.name);
  return names;
}

LumpedModel scaled(LumpedModel model, const std::string& number, double factor) {
  const auto scale = [&](ParameterValues& numbers) {
    if (const auto found = numbers.find(number); found != numbers.end()) found->second *= factor;
  };
  scale(model.parameters);
  for (auto& entry : model.at_speed) scale(entry.parameters);
  return model;
}

LawFactors::LawFactors(LumpedModel believed, const std::vector<Ball>& balls,
                       std::vector<CalibrationParameter>& unknowns)
    : believed_(std::move(believed)), parameters_(unknown_numbers(believed_)) {
  constexpr double reach = 3.0;  // a factor of twenty either way
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
  for (std::size_t p = 0; p < parameters_.size(); ++p)
    model = scaled(std::move(model), parameters_[p], std::exp(values[places_[ball][p]]));
  return model;
}

}  // namespace rebound
