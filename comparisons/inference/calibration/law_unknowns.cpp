#include "comparisons/inference/calibration/law_unknowns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/toml/units.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/laws/law_card.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr double same_speed = 1e-6;

double peak_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

double guess_of(const ParameterCard& card, const ParameterValues& values,
                const MeasuredImpact& shot) {
  if (card.default_value) return *card.default_value;
  const Dimension d = card.dimension(values);
  if (d == dimension::none) return 0.5;
  const double force = peak_of(shot.trace.force), x = peak_of(shot.trace.deflection);
  // kg m/s² to the power a, m to the power b, m/s to the power c.
  const double a = d.kilogram, c = -(d.second + 2.0 * a), b = d.metre - a - c;
  const double size = std::pow(force, a) * std::pow(x, b) * std::pow(shot.impact.speed, c);
  return c == 0.0 ? size : size / 3.0;
}

}  // namespace

const ParameterCard& card_of(const LawCard& law, const std::string& name) {
  for (const auto& p : law.parameters)
    if (p.name == name) return p;
  throw Error(ExitCode::bad_input, "law '" + law.name + "' has no parameter '" + name + "'",
              {.key = name, .value = "", .allowed = "a parameter of the law"});
}

CalibrationParameter law_unknown(const ParameterCard& card, const ParameterValues& values,
                                 const MeasuredImpact& shot) {
  const bool number = card.dimension(values) == dimension::none;
  const double guess = guess_of(card, values, shot);
  CalibrationParameter p{.name = card.name,
                         .unit = unit_name(card.dimension(values)),
                         .start = guess,
                         .lowest = number ? card.range.lowest : guess * 1e-4,
                         .highest = number ? card.range.highest : guess * 1e4,
                         .scale = guess};
  if (number && !card.range.lowest_allowed) p.lowest += 1e-3;
  return p;
}

const MeasuredImpact& fastest(const std::vector<MeasuredImpact>& shots) {
  return *std::max_element(shots.begin(), shots.end(), [](const auto& a, const auto& b) {
    return a.impact.speed < b.impact.speed;
  });
}

LawUnknowns::LawUnknowns(const std::string& law, const std::vector<MeasuredImpact>& shots,
                         const Choice& choice)
    : law_(law), fixed_(choice.fixed), guessed_(choice.fixed) {
  const LawCard& card = find_law(law);
  for (const auto& [name, value] : choice.fixed) {
    card_of(card, name);
    if (contains(choice.per_speed, name) || contains(choice.also_free, name))
      throw Error(ExitCode::bad_input, "a parameter is both fixed and free",
                  {.key = name, .value = fmt::format("{}", value), .allowed = "one of the two"});
  }
  for (const auto* names : {&choice.also_free, &choice.per_speed})
    for (const auto& name : *names) card_of(card, name);
  for (const auto& shot : shots) {
    const double speed = shot.impact.speed;
    const auto known = std::find_if(speeds_.begin(), speeds_.end(), [&](double s) {
      return std::abs(s - speed) <= same_speed * speed;
    });
    speed_of_shot_.push_back(static_cast<int>(known - speeds_.begin()));
    if (known == speeds_.end()) speeds_.push_back(speed);
  }
  for (const auto& p : card.parameters) {
    const bool per_speed = contains(choice.per_speed, p.name);
    const bool named = per_speed || contains(choice.also_free, p.name);
    if (choice.fixed.contains(p.name) || (p.default_value && !named)) continue;
    add(p, per_speed, shots);
  }
  if (parameters_.empty())
    throw Error(ExitCode::bad_input, "every parameter of '" + law + "' is fixed: nothing to fit");
}

void LawUnknowns::add(const ParameterCard& card, bool per_speed,
                      const std::vector<MeasuredImpact>& shots) {
  const CalibrationParameter shared = law_unknown(card, guessed_, fastest(shots));
  if (!per_speed) {
    unknowns_.push_back({card.name, -1});
    parameters_.push_back(shared);
  } else {
    for (std::size_t s = 0; s < speeds_.size(); ++s) {
      const auto shot = static_cast<std::size_t>(
          std::find(speed_of_shot_.begin(), speed_of_shot_.end(), static_cast<int>(s)) -
          speed_of_shot_.begin());
      CalibrationParameter p = law_unknown(card, guessed_, shots[shot]);
      p.name = fmt::format("{} at {:g} m/s", card.name, speeds_[s]);
      unknowns_.push_back({card.name, static_cast<int>(s)});
      parameters_.push_back(p);
    }
  }
  guessed_[card.name] = shared.start;
}

LumpedModel LawUnknowns::model(const std::vector<double>& x) const {
  LumpedModel model;
  model.law = law_;
  model.parameters = fixed_;
  std::vector<ParametersAtSpeed> entries;
  for (double speed : speeds_) entries.push_back({speed, {}});
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const auto& [name, speed] = unknowns_[i];
    (speed < 0 ? model.parameters : entries[static_cast<std::size_t>(speed)].parameters)[name] =
        x[i];
  }
  if (!entries.front().parameters.empty()) model.at_speed = std::move(entries);
  return model;
}

LumpedModel LawUnknowns::model_for(const std::vector<double>& x, std::size_t shot) const {
  LumpedModel model;
  model.law = law_;
  model.parameters = fixed_;
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    if (unknowns_[i].speed < 0 || unknowns_[i].speed == speed_of_shot_[shot])
      model.parameters[unknowns_[i].name] = x[i];
  return model;
}

ShotSlopes LawUnknowns::slopes_for(std::size_t shot) const {
  ShotSlopes slopes;
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    if (unknowns_[i].speed < 0 || unknowns_[i].speed == speed_of_shot_[shot])
      slopes.add(direction_of(law_, unknowns_[i].name), i);
  return slopes;
}

}  // namespace rebound
