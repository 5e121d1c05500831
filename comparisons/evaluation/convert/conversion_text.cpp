#include "comparisons/evaluation/convert/conversion_text.hpp"

#include <fmt/format.h>

namespace rebound {
namespace {

Json to_json(const ConvertedLaw& law) {
  if (!law.failure.empty()) return {{"failure", law.failure}};
  Json parameters = Json::array();
  for (const auto& p : law.parameters)
    parameters.push_back({{"name", p.name}, {"value", p.value}, {"unit", p.unit}});
  return {{"failure", nullptr},
          {"parameters", parameters},
          {"returned", to_json(law.returned)},
          {"error", errors_json(law.error)}};
}

std::string errors(const ConvertedLaw& law) {
  if (!law.failure.empty()) return "none: " + law.failure;
  const auto percent = [](const std::optional<double>& value) {
    return value ? fmt::format("{:>+9.2f} %", 100.0 * *value) : fmt::format("{:>11}", "-");
  };
  return fmt::format("{:>+10.4f}{}{}", law.error.restitution.value_or(0.0),
                     percent(law.error.contact_time), percent(law.error.peak_force));
}

std::string parameters(const ConvertedLaw& law) {
  std::string text;
  for (const auto& p : law.parameters)
    text += fmt::format("{}{} = {:.6g}{}{}", text.empty() ? "" : ", ", p.name, p.value,
                        p.unit == "1" ? "" : " ", p.unit == "1" ? "" : p.unit);
  return text;
}

}  // namespace

Json to_json(const Observed& o) {
  return {{"restitution", number_or_null(o.restitution)},
          {"contact_time_s", number_or_null(o.contact_time)},
          {"peak_force_N", number_or_null(o.peak_force)}};
}

Json errors_json(const Observed& error) {
  return {{"restitution", number_or_null(error.restitution)},
          {"contact_time", number_or_null(error.contact_time)},
          {"peak_force", number_or_null(error.peak_force)}};
}

Json to_json(const ConversionRequest& request, const ConversionTable& table) {
  Json rows = Json::array();
  for (const auto& c : table.conversions)
    rows.push_back({{"convention", c.convention},
                    {"law", c.law},
                    {"used_by", c.used_by},
                    {"formula", c.formula},
                    {"formula_assumes", name_of(c.assumes)},
                    {"by_formula", to_json(c.by_formula)},
                    {"matched", to_json(c.matched)}});
  return {{"schema", 1},
          {"speed_m_s", request.impact.speed},
          {"check_speed_m_s", request.check_speed.value_or(request.impact.speed)},
          {"separation_rule", name_of(request.impact.separation)},
          {"meaning",
           {{"basis", table.meaning.basis},
            {"at_impact", to_json(table.meaning.at_impact)},
            {"at_check", to_json(table.meaning.at_check)},
            {"hertz_stiffness_N_m1.5", table.meaning.hertz_stiffness},
            {"elastic_contact_time_s", table.meaning.elastic_contact_time}}},
          {"conversions", rows}};
}

std::string to_text(const ConversionRequest& request, const ConversionTable& table) {
  const auto& m = table.meaning;
  std::string text = fmt::format("given: {}\n", m.basis);
  text += fmt::format("at {:g} m/s, {}: e = {:.5g}", request.impact.speed,
                      name_of(request.impact.separation), m.at_impact.restitution.value_or(0.0));
  if (m.at_impact.contact_time)
    text += fmt::format(", t = {:.5g} ms", 1e3 * *m.at_impact.contact_time);
  if (m.at_impact.peak_force) text += fmt::format(", F = {:.5g} N", *m.at_impact.peak_force);
  text += fmt::format("\n\nerrors at {:g} m/s\n{:<34}{:<14}{:>10}{:>11}{:>11}\n",
                      request.check_speed.value_or(request.impact.speed), "convention", "", "e",
                      "t", "F max");
  for (const auto& c : table.conversions) {
    text += fmt::format("{:<34}{:<14}{}\n", c.convention, "by formula", errors(c.by_formula));
    text += fmt::format("{:<34}{:<14}{}\n", "", "matched", errors(c.matched));
    if (c.by_formula.failure.empty()) text += "    by formula  " + parameters(c.by_formula) + "\n";
    if (c.matched.failure.empty()) text += "    matched     " + parameters(c.matched) + "\n";
  }
  return text;
}

}  // namespace rebound
