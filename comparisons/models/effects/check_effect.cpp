#include "comparisons/models/effects/check_effect.hpp"

#include <algorithm>

#include "lumped/problem/error.hpp"

namespace rebound {

EffectChoice checked_choice(const EffectCard& card, const EffectChoice& choice,
                            const std::string& path) {
  if (choice.size != card.null && !card.range.contains(choice.size))
    refuse_value(path + ".size", choice.size, allowed_text(card.range, size_unit(card)));
  for (const auto& given : choice.parameters) {
    const std::string& name = given.first;
    const auto same = [&](const EffectParameterCard& p) { return p.name == name; };
    if (std::none_of(card.parameters.begin(), card.parameters.end(), same))
      throw Error(
          ExitCode::bad_input, "the effect '" + card.name + "' has no parameter '" + name + "'",
          {.key = std::string(path).append(".").append(name), .value = number_text(given.second)});
  }
  EffectChoice complete = choice;
  for (const EffectParameterCard& parameter : card.parameters) {
    const double value =
        complete.parameters.emplace(parameter.name, parameter.default_value).first->second;
    if (!parameter.range.contains(value))
      refuse_value(path + "." + parameter.name, value,
                   allowed_text(parameter.range, unit_name(parameter.dimension)));
  }
  return complete;
}

}  // namespace rebound
