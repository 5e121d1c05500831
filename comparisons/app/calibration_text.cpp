#include "comparisons/app/calibration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "comparisons/inference/references/scalar_errors_json.hpp"

namespace rebound {

namespace {

Json profile_json(const Estimate& estimate) {
  if (!estimate.profile) return nullptr;
  const ProfileInterval& p = *estimate.profile;
  return {{"interval", {p.low, p.high}},
          {"closed", {p.low_closed, p.high_closed}},
          {"value", p.value},
          {"cost", p.cost}};
}

Json to_json(const LawScore& cell) {
  if (!cell.failure.empty()) return {{"failure", cell.failure}};
  return {{"failure", nullptr},
          {"restitution", cell.scalars.restitution},
          {"contact_time_s", cell.scalars.contact_time},
          {"peak_force_N", cell.scalars.peak_force},
          {"peak_deflection_m", cell.scalars.peak_deflection},
          {"mean_deflection_m", cell.scalars.mean_deflection},
          {"force_time_rms", cell.force_time_rms},
          {"force_deflection_rms", cell.force_deflection_rms},
          {"against_reference", to_json(cell.against_reference)},
          {"against_measured", to_json(cell.against_measured)}};
}

using Quantity = std::function<std::optional<double>(const LawScore&)>;

std::string block(const BenchmarkMatrix& matrix, const std::string& title,
                  const Quantity& quantity) {
  bool anything = false;
  std::string text = fmt::format("\n{} [%]\n", title);
  for (std::size_t i = 0; i < matrix.laws.size(); ++i) {
    text += fmt::format("  {:<32}", matrix.laws[i]);
    for (const auto& cell : matrix.cells[i]) {
      const auto value = cell.failure.empty() ? quantity(cell) : std::nullopt;
      anything = anything || value;
      text += !cell.failure.empty() ? fmt::format("{:>12}", "none")
              : value               ? fmt::format("{:>+12.2f}", 100.0 * *value)
                                    : fmt::format("{:>12}", "-");
    }
    text += "\n";
  }
  return anything ? text : "";
}

std::string failures(const BenchmarkMatrix& matrix) {
  std::string text;
  for (std::size_t i = 0; i < matrix.laws.size(); ++i)
    for (std::size_t j = 0; j < matrix.cells[i].size(); ++j)
      if (!matrix.cells[i][j].failure.empty())
        text += fmt::format("  {} at {}: {}\n", matrix.laws[i], matrix.references[j],
                            matrix.cells[i][j].failure);
  return text.empty() ? "" : "\nNo answer\n" + text;
}

}  // namespace

Json to_json(const CalibrationOutput& output) {
  Json json = output.head;
  json.update(to_json(output.fit));
  json["seed"] = output.seed;
  json["model_toml"] = output.model_toml;
  return json;
}

Json to_json(const CalibrationResult& result) {
  Json estimates = Json::array();
  for (const auto& e : result.estimates)
    estimates.push_back({{"name", e.name},
                         {"unit", e.unit},
                         {"value", e.value},
                         {"standard_error", number_or_null(e.standard_error)},
                         {"interval", {e.low, e.high}},
                         {"profile", profile_json(e)},
                         {"identifiability", name_of(e.identifiability)},
                         {"verdict", e.verdict}});
  return {{"estimates", estimates},
          {"correlation", result.correlation},
          {"cost_before", result.cost_before},
          {"cost_after", result.cost_after},
          {"reduced_chi_square", result.reduced_chi_square},
          {"residual_autocorrelation", result.residual_autocorrelation},
          {"data", result.data},
          {"evaluations", result.evaluations},
          {"converged", result.converged},
          {"noise", result.noise == NoiseKnowledge::known ? "known" : "estimated"},
          {"warnings", result.warnings},
          {"verdict", result.verdict}};
}

std::string to_text(const CalibrationResult& result) {
  std::string text;
  for (const auto& e : result.estimates) {
    text += fmt::format("{:<28}{:.6g} {}  [{:.6g}, {:.6g}]  {}\n", e.name, e.value, e.unit, e.low,
                        e.high, e.verdict);
    if (e.profile)
      text += fmt::format("{:<28}by likelihood ratio {}{:.6g}, {:.6g}{}\n", "",
                          e.profile->low_closed ? "[" : "(open ", e.profile->low, e.profile->high,
                          e.profile->high_closed ? "]" : " open)");
  }
  text += fmt::format("{:<28}{:.6g} -> {:.6g}  ({} data, {} model runs)\n", "cost",
                      result.cost_before, result.cost_after, result.data, result.evaluations);
  text += fmt::format("{:<28}{}\n", "verdict", result.verdict);
  for (const auto& warning : result.warnings) text += fmt::format("{:<28}{}\n", "warning", warning);
  return text;
}

Json to_json(const BenchmarkMatrix& matrix) {
  Json references = Json::array(), cells = Json::array();
  for (std::size_t j = 0; j < matrix.references.size(); ++j)
    references.push_back({{"label", matrix.references[j]}, {"speed_m_s", matrix.speeds[j]}});
  for (const auto& row : matrix.cells) {
    Json line = Json::array();
    for (const auto& cell : row) line.push_back(to_json(cell));
    cells.push_back(line);
  }
  return {{"laws", matrix.laws}, {"references", references}, {"cells", cells}};
}

std::string to_text(const BenchmarkMatrix& matrix) {
  std::string text = "References\n";
  for (std::size_t j = 0; j < matrix.references.size(); ++j)
    text += fmt::format("  {:>2}  {}\n", j + 1, matrix.references[j]);
  const std::pair<const char*, Quantity> quantities[] = {
      {"Peak force, against the reference",
       [](const auto& c) { return c.against_reference.peak_force; }},
      {"Peak deflection, against the reference",
       [](const auto& c) { return c.against_reference.peak_deflection; }},
      {"Contact time, against the reference",
       [](const auto& c) { return c.against_reference.contact_time; }},
      {"Restitution, against the reference",
       [](const auto& c) { return c.against_reference.restitution; }},
      {"Force over time, RMS of peak",
       [](const auto& c) { return std::optional(c.force_time_rms); }},
      {"Force over deflection, RMS of peak",
       [](const auto& c) { return std::optional(c.force_deflection_rms); }},
      {"Peak force, against the measurement",
       [](const auto& c) { return c.against_measured.peak_force; }},
      {"Contact time, against the measurement",
       [](const auto& c) { return c.against_measured.contact_time; }},
      {"Restitution, against the measurement",
       [](const auto& c) { return c.against_measured.restitution; }},
  };
  for (const auto& [title, quantity] : quantities) text += block(matrix, title, quantity);
  return text + failures(matrix);
}

}  // namespace rebound
