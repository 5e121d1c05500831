#include "comparisons/discrepancy/trials/trial_outcome.hpp"

#include <limits>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Json value_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

/// JSON has no number that is not finite: an interval without an end is written as null.
double number_or_nan(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

TrialOutcome outcome_of(const Json& json) {
  TrialOutcome outcome{.trial = json.at("trial"),
                       .said = trial_answer_from(json),
                       .failure = json.at("failure"),
                       .warnings = json.at("warnings").get<std::vector<std::string>>(),
                       .speeds = json.at("speeds"),
                       .shots = json.at("shots"),
                       .seconds = json.at("seconds"),
                       .controls = {},
                       .protocol = json.at("protocol")};
  outcome.size = number_or_nan(json.at("size").at(0));
  outcome.size_low = number_or_nan(json.at("size").at(1));
  outcome.size_high = number_or_nan(json.at("size").at(2));
  outcome.held_out_before = optional_number(json.at("held_out").at(0));
  outcome.held_out_after = optional_number(json.at("held_out").at(1));
  outcome.held_out_noise = json.at("held_out_noise");
  for (const auto& [name, control] : json.at("controls").items())
    outcome.controls[name] = trial_answer_from(control);
  return outcome;
}

}  // namespace

Json to_json(const TrialOutcome& outcome) {
  Json json = {{"schema", 1}, {"trial", outcome.trial}};
  json.update(to_json(outcome.said));
  json["failure"] = outcome.failure;
  json["size"] = {outcome.size, outcome.size_low, outcome.size_high};
  json["held_out"] = {value_or_null(outcome.held_out_before),
                      value_or_null(outcome.held_out_after)};
  json["held_out_noise"] = outcome.held_out_noise;
  json["warnings"] = outcome.warnings;
  json["speeds"] = outcome.speeds;
  json["shots"] = outcome.shots;
  json["seconds"] = outcome.seconds;
  json["controls"] = Json::object();
  for (const auto& [name, control] : outcome.controls) json["controls"][name] = to_json(control);
  json["protocol"] = outcome.protocol;
  return json;
}

TrialOutcome trial_outcome_from(const std::string& text, const std::string& file) {
  try {
    return outcome_of(Json::parse(text));
  } catch (const Json::exception& error) {
    throw Error(ExitCode::corrupt_store,
                std::string("is not the outcome of a trial: ") + error.what(),
                {.file = file,
                 .allowed = "as this version writes it; a file that is removed is "
                            "made again"});
  }
}

}  // namespace rebound
