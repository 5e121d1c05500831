#include "comparisons/inference/references/read_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "comparisons/inference/references/contact_alone.hpp"
#include "comparisons/io/dataset/csv_table.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

std::vector<MeasuredImpact> from_dataset(const std::filesystem::path& folder) {
  const Dataset dataset = read_dataset(folder);
  std::vector<MeasuredImpact> references;
  for (const auto& shot : dataset.shots) {
    if (!shot.has_history()) continue;
    references.push_back(contact_alone(completed(dataset, shot)));
    references.back().label = fmt::format("{} {:.4g} m/s", dataset.name, shot.impact.speed);
  }
  if (references.empty())
    throw Error(ExitCode::bad_input, "none of the data set's shots has a trace to compare with",
                {.file = (folder / "dataset.toml").string(), .key = "shot.trace"});
  return references;
}

[[noreturn]] void corrupt(const std::filesystem::path& file, const std::string& message) {
  throw Error(ExitCode::corrupt_store, message, {.file = file.string()});
}

ImpactScalars stored_scalars(const std::filesystem::path& file) {
  try {
    const auto json = nlohmann::json::parse(read_text_file(file));
    const auto number = [&](const char* key) { return json.at(key).get<double>(); };
    SeparationRule separation{};
    if (!read_name(json.at("separation_rule").get<std::string>(), separation))
      corrupt(file, "its separation rule is not known");
    return {.restitution = number("restitution"),
            .contact_time = number("contact_time_s"),
            .contact_time_1pct = number("contact_time_1pct_s"),
            .peak_force = number("peak_force_N"),
            .peak_deflection = number("peak_deflection_m"),
            .mean_deflection = number("mean_deflection_m"),
            .rebound_speed = number("rebound_speed_m_s"),
            .separation = separation};
  } catch (const nlohmann::json::exception& error) {
    corrupt(file, fmt::format("this is not a whole result: {}", error.what()));
  }
}

/// Sphere and impact of the effective configuration, whichever its tier.
std::pair<Sphere, Impact> stored_impact(const std::filesystem::path& file) {
  const Document document = Document::load(file);
  if (document.root()["model"]["tier"].value<std::string>() == "fem") {
    const FemProblem problem = read_fem_problem(document);
    return {problem.sphere, problem.impact};
  }
  const LumpedProblem problem = read_lumped_problem(document);
  return {problem.sphere, problem.impact};
}

MeasuredImpact from_result(const std::filesystem::path& folder) {
  MeasuredImpact shot;
  std::tie(shot.sphere, shot.impact) = stored_impact(folder / "effective.toml");
  shot.scalars = stored_scalars(folder / "result.json");
  CsvTable table = read_csv(
      folder / "trace.csv",
      {.needed = {"time_s", "force_N", "deflection_m"}, .optional = {}, .increasing = "time_s"});
  shot.trace.time = std::move(table.columns[0]);
  shot.trace.force = std::move(table.columns[1]);
  shot.trace.deflection = std::move(table.columns[2]);
  const double speed = shot.scalars.rebound_speed / shot.scalars.restitution;
  if (!(std::abs(speed / shot.impact.speed - 1.0) < 1e-9))
    corrupt(folder / "result.json", "result.json and effective.toml are of different impacts");
  if (table.left_out_line != 0) corrupt(folder / "trace.csv", "the last line is cut off");
  shot.label = fmt::format("{} {:.4g} m/s", folder.filename().string(), shot.impact.speed);
  return shot;
}

}  // namespace

std::vector<MeasuredImpact> read_references(const std::filesystem::path& folder) {
  std::error_code status;
  if (std::filesystem::exists(folder / "dataset.toml", status)) return from_dataset(folder);
  if (std::filesystem::exists(folder / "result.json", status)) return {from_result(folder)};
  if (!std::filesystem::is_directory(folder, status))
    throw Error(ExitCode::input_output_failed,
                "there is no such folder: a data set, or what `rebound lumped` or `rebound fem` "
                "FILE --out FOLDER writes",
                {.file = folder.string(), .key = "reference.folder"});
  throw Error(ExitCode::bad_input,
              "the folder is neither a data set (dataset.toml) nor a complete result (result.json)",
              {.file = folder.string(),
               .key = "reference.folder",
               .allowed = "a data-set folder or a folder written by --out"});
}

std::vector<MeasuredImpact> read_scalar_references(const std::filesystem::path& folder) {
  const Dataset dataset = read_dataset(folder);
  std::vector<MeasuredImpact> references;
  for (const MeasuredImpact& shot : dataset.shots) {
    if (std::none_of(scalar_quantities.begin(), scalar_quantities.end(),
                     [&](const ScalarQuantity& one) { return (shot.*one.measured).has_error(); }))
      continue;
    references.push_back(completed(dataset, shot));
    references.back().label = fmt::format("{} {:.4g} m/s", dataset.name, shot.impact.speed);
  }
  if (references.empty())
    throw Error(ExitCode::bad_input, "no shot of the data set states a scalar with its uncertainty",
                {.file = (folder / "dataset.toml").string(), .key = "shot"});
  return references;
}

}  // namespace rebound
