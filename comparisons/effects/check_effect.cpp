#include "comparisons/effects/check_effect.hpp"

#include <algorithm>
#include <sstream>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

std::string text(double value) {
  std::ostringstream out;
  out.precision(9);
  out << value;
  return out.str();
}

void require_in(double lowest, double highest, double value, const std::string& key) {
  if (value >= lowest && value <= highest) return;  // false for NaN as well
  throw Error(ExitCode::bad_input, "the value is out of range",
              {.key = key, .value = text(value),
               .allowed = "[" + text(lowest) + ", " + text(highest) + "] in SI units"});
}

}  // namespace

EffectChoice checked_choice(const EffectCard& card, const EffectChoice& choice,
                            const std::string& path) {
  if (choice.size != card.null)
    require_in(card.lowest, card.highest, choice.size, path + ".size");
  for (const auto& [name, value] : choice.parameters) {
    const auto same = [&](const EffectParameterCard& p) { return p.name == name; };
    if (std::none_of(card.parameters.begin(), card.parameters.end(), same))
      throw Error(ExitCode::bad_input,
                  "the effect '" + card.name + "' has no parameter '" + name + "'",
                  {.key = path + "." + name, .value = text(value)});
  }
  EffectChoice complete = choice;
  for (const EffectParameterCard& parameter : card.parameters) {
    const double value =
        complete.parameters.emplace(parameter.name, parameter.default_value).first->second;
    require_in(parameter.lowest, parameter.highest, value, path + "." + parameter.name);
  }
  return complete;
}

}  // namespace rebound
