#include "comparisons/evaluation/drop_test/stored_calibration.hpp"

#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

ParameterUncertainty uncertainty_of(const Json& json) {
  ParameterUncertainty u;
  for (const auto& estimate : json.at("estimates")) {
    u.names.push_back(estimate.at("name").get<std::string>());
    u.standard_errors.push_back(estimate.at("standard_error").get<double>());
  }
  u.correlation = json.at("correlation").get<std::vector<std::vector<double>>>();
  return u;
}

}  // namespace

StoredCalibration read_stored_calibration(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  try {
    const Json json = Json::parse(text);
    StoredCalibration stored;
    const Document model = Document::parse(json.at("model_toml").get<std::string>(), file.string());
    if (json.value("tier", "lumped") == "fem")
      stored.problem = read_fem_problem(model);
    else
      stored.problem = read_lumped_problem(model);
    for (const auto& estimate : json.at("estimates"))
      if (estimate.at("standard_error").is_null())
        stored.why_not += (stored.why_not.empty() ? "not identifiable: " : ", ") +
                          estimate.at("name").get<std::string>();
    const auto* lumped = std::get_if<LumpedProblem>(&stored.problem);
    if (lumped && !lumped->model.at_speed.empty())
      stored.why_not = "its parameters were fitted speed by speed";
    if (stored.why_not.empty()) stored.uncertainty = uncertainty_of(json);
    return stored;
  } catch (const Json::exception& error) {
    throw Error(ExitCode::corrupt_store,
                std::string("this is no whole calibration result: ") + error.what(),
                {.file = file.string()});
  } catch (const Error& error) {
    throw Error(ExitCode::corrupt_store,
                std::string("the model of this calibration cannot be read: ") + error.what(),
                {.file = file.string()});
  }
}

}  // namespace rebound
