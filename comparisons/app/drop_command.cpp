#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/drop_test/fem_drop.hpp"
#include "comparisons/evaluation/drop_test/regulation.hpp"
#include "comparisons/evaluation/drop_test/stored_calibration.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string drop_help() {
  const Regulation regulation;
  return fmt::format(
             "FILE is an impact file of either tier, or calibration.json (or the folder it lies "
             "in) "
             "as `rebound\ncalibrate --out` writes it. The speed of the file is replaced by that "
             "of "
             "the drop.\nBand: restitution {:g} to {:g} from {:g} m (Hanley et al., sliotar core "
             "impact, section 1).\nAn interval needs a calibration; without one the value is "
             "judged "
             "alone, and said to be.\n--out writes drop.json.\n\n",
             regulation.lowest, regulation.highest, regulation.drop_height) +
         exit_code_help();
}

bool is_fem(const Document& document) {
  return document.root()["model"]["tier"].value_or(std::string()) == "fem";
}

DropOutcome fem_drop(const FemProblem& problem,
                     const std::optional<ParameterUncertainty>& uncertainty,
                     const DropOptions& options) {
  ProgressLine progress("FE impacts");
  const RunControl control = progress.control();
  FemProblem dropped = problem;
  dropped.impact.speed = drop_speed(options.height);
  const Mesh mesh = mesh_for(dropped, control);
  DropOutcome outcome =
      drop_test(problem, uncertainty, fem_runner(mesh, problem.sphere, control), options);
  outcome.cells = static_cast<int>(mesh.cells.size());
  return outcome;
}

DropOutcome calibration_drop(const std::filesystem::path& file, const DropOptions& options) {
  const StoredCalibration stored = read_stored_calibration(file);
  const auto* fem = std::get_if<FemProblem>(&stored.problem);
  DropOutcome outcome =
      fem ? fem_drop(*fem, stored.uncertainty, options)
          : drop_test(std::get<LumpedProblem>(stored.problem), stored.uncertainty, options);
  if (!stored.why_not.empty())
    outcome.notes.push_back("the calibration's uncertainty is not carried: " + stored.why_not);
  return outcome;
}

/// A folder stands for the calibration in it.
std::filesystem::path input_of(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? path / "calibration.json" : path;
}

DropOutcome run(const std::filesystem::path& path, const DropOptions& options) {
  if (path.extension() == ".json") return calibration_drop(path, options);
  const Document document = Document::load(path);
  if (is_fem(document)) return fem_drop(read_fem_problem(document), std::nullopt, options);
  return drop_test(read_lumped_problem(document), std::nullopt, options);
}

const char* name_of(DropVerdict verdict) {
  switch (verdict) {
    case DropVerdict::inside: return "inside";
    case DropVerdict::below: return "below";
    case DropVerdict::above: return "above";
    case DropVerdict::undecided: break;
  }
  return "undecided";
}

Json to_json(const DropOutcome& outcome, const DropOptions& options) {
  const Regulation regulation;
  const auto& interval = outcome.interval;
  return {{"schema", 1},
          {"drop_height_m", options.height},
          {"speed_m_s", outcome.speed},
          {"restitution", outcome.restitution},
          {"interval", interval ? Json({interval->first, interval->second}) : Json(nullptr)},
          {"confidence", options.confidence},
          {"probability_inside", number_or_null(outcome.probability_inside)},
          {"regulation",
           {{"drop_height_m", regulation.drop_height},
            {"restitution", {regulation.lowest, regulation.highest}}}},
          {"verdict", name_of(outcome.verdict)},
          {"sentence", sentence_of(outcome)},
          {"notes", outcome.notes},
          {"cells", outcome.cells ? Json(*outcome.cells) : Json(nullptr)},
          {"draws", options.draws},
          {"seed", options.seed}};
}

std::string to_text(const DropOutcome& outcome, const DropOptions& options) {
  std::string text = fmt::format("drop of {:g} m: {:.4g} m/s\nrestitution {:.4f}", options.height,
                                 outcome.speed, outcome.restitution);
  if (outcome.interval)
    text += fmt::format("  [{:.4f}, {:.4f}] at {:g} %", outcome.interval->first,
                        outcome.interval->second, 100.0 * options.confidence);
  text += "\n" + sentence_of(outcome) + "\n";
  for (const auto& note : outcome.notes) text += "note: " + note + "\n";
  return text;
}

ExitCode run_drop(const Session& session, const std::string& given, const std::string& height,
                  DropOptions options) {
  const std::filesystem::path path = input_of(given);
  try {
    options.height = parse_quantity(height, dimension::length);
  } catch (const Error& error) {
    throw Error(error.code(), error.what(),
                {.key = "--height", .value = height, .allowed = "e.g. \"1.8 m\""});
  }
  if (!session.out.empty()) make_writable_folder(session.out);
  const DropOutcome outcome = run(path, options);
  const Json json = to_json(outcome, options);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path.string(), read_text_file(path)));
    write_file_atomically(session.out / "drop.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(outcome, options));
  return ExitCode::done;
}

}  // namespace

Action declare_drop(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  const auto height = std::make_shared<std::string>("1.8 m");
  const auto options = std::make_shared<DropOptions>();
  command.add_option("FILE", *file, "Impact file of either tier, or a calibration result")
      ->required();
  command.add_option("--height", *height, "Drop height with its unit")->capture_default_str();
  command.add_option("--confidence", options->confidence, "Of the interval")->capture_default_str();
  command.add_option("--draws", options->draws, "Draws of the parameters")->capture_default_str();
  command.add_option("--seed", options->seed, "Seed of the draws")->capture_default_str();
  command.footer(drop_help);
  return [=](const Session& session) { return run_drop(session, *file, *height, *options); };
}

}  // namespace rebound
