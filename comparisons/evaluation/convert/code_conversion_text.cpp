#include "comparisons/evaluation/convert/code_conversion_text.hpp"

#include <fmt/format.h>

#include "comparisons/evaluation/convert/conversion_text.hpp"

namespace rebound {
namespace {

Json to_json(const CodeError& error) {
  return {{"speed_m_s", error.speed},
          {"failure", error.failure.empty() ? Json(nullptr) : Json(error.failure)},
          {"returned", to_json(error.returned)},
          {"restitution_range",
           error.restitution_range ? Json(*error.restitution_range) : Json(nullptr)},
          {"law_error", error.of_law ? errors_json(*error.of_law) : Json(nullptr)},
          {"fem_error", error.of_fem ? errors_json(*error.of_fem) : Json(nullptr)},
          {"fem_failure", error.fem_failure.empty() ? Json(nullptr) : Json(error.fem_failure)}};
}

std::string errors_text(const std::optional<Observed>& error) {
  if (!error) return fmt::format("{:>9}{:>10}{:>10}", "-", "-", "-");
  const auto percent = [](const std::optional<double>& value) {
    return value ? fmt::format("{:>+8.2f} %", 100.0 * *value) : fmt::format("{:>10}", "-");
  };
  return fmt::format("{:>+9.4f}{}{}", error->restitution.value_or(0.0),
                     percent(error->contact_time), percent(error->peak_force));
}

std::string row_text(const CodeError& error) {
  if (!error.failure.empty())
    return fmt::format("{:>8.4g}   none: {}\n", error.speed, error.failure);
  return fmt::format(
      "{:>8.4g}{:>9.4f}{:>9.4g}{:>9.4g}   {}   {}\n", error.speed, *error.returned.restitution,
      1e3 * *error.returned.contact_time, *error.returned.peak_force, errors_text(error.of_law),
      error.fem_failure.empty() ? errors_text(error.of_fem) : "none: " + error.fem_failure);
}

}  // namespace

Json to_json(const OtherCode& code, const CodeConversion& conversion) {
  Json settings = Json::array(), errors = Json::array();
  for (const ConvertedParameter& setting : conversion.settings)
    settings.push_back({{"name", setting.name}, {"value", setting.value}, {"unit", setting.unit}});
  for (const CodeError& error : conversion.errors) errors.push_back(to_json(error));
  return {{"schema", 1},
          {"to", code.name},
          {"code", code.title},
          {"force", code.force},
          {"separation_rule", name_of(code.separation)},
          {"source", code.source},
          {"cautions", code.cautions},
          {"mass_kg", conversion.contact.sphere.mass},
          {"diameter_m", conversion.contact.sphere.diameter},
          {"speed_m_s", conversion.contact.speed},
          {"settings", settings},
          {"lines", conversion.lines},
          {"errors", errors}};
}

std::string to_text(const OtherCode& code, const CodeConversion& conversion) {
  const CodeContact& contact = conversion.contact;
  std::string text = conversion.lines + "\n";
  text += fmt::format(
      "{}\n  {}\n  holds for {:.6g} g, {:.6g} mm, at {:.6g} m/s on a wall at rest\n", code.title,
      code.force, 1e3 * contact.sphere.mass, 1e3 * contact.sphere.diameter, contact.speed);
  for (const char* caution : code.cautions) text += fmt::format("  {}\n", caution);
  text += fmt::format("  source: {}\n\n", code.source);
  text += fmt::format("{:>35}   {:^29}   {:^29}\n", "", "error against what was given",
                      "error against FE");
  text += fmt::format("{:>8}{:>9}{:>9}{:>9}   {:>9}{:>10}{:>10}   {:>9}{:>10}{:>10}\n", "v m/s",
                      "e", "t ms", "F N", "e", "t", "F max", "e", "t", "F max");
  for (const CodeError& error : conversion.errors) text += row_text(error);
  for (const CodeError& error : conversion.errors)
    if (error.restitution_range)
      text +=
          fmt::format("  as the touch falls into a step: e {:.4f} to {:.4f} at {:.4g} m/s\n",
                      (*error.restitution_range)[0], (*error.restitution_range)[1], error.speed);
  return text;
}

}  // namespace rebound
