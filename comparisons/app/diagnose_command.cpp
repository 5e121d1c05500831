#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <utility>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct DiagnoseOptions {
  std::vector<std::string> folders;
  std::string model;
  std::string hold_out;
  std::string mesh;
  std::uint64_t seed = 1;
  bool fail_on_gap = false;
  bool no_bootstrap = false;
  bool no_fem = false;
};

std::string diagnose_help() {
  std::string text =
      "Fits the believed model of MODEL to all shots but those at one speed, looks for the "
      "smallest\n"
      "sets of effects that explain what is left, and predicts the speed that was left out.\n"
      "Verdicts: agrees, missing, family, one-of, unexplained, measurement-fault, "
      "insufficient-data.\n"
      "Results go to --out, or else to results/diagnosis-NAME of the first data set's folder:\n"
      "diagnosis.json, report.html and, where effects were found, extended.toml (extended-2.toml "
      "of "
      "a\n"
      "second ball, and so on), a model file that lumped, synthesize and diagnose take as it "
      "stands.\n\nEffects:\n";
  for (const Effect& effect : all_effects())
    text += fmt::format("  {:<26} {}\n", effect.card.name, effect.card.sentence);
  return text + "\n" + exit_code_help();
}

std::filesystem::path folder_for(const Session& session, const DiagnoseOptions& options) {
  if (!session.out.empty()) return session.out;
  const auto first = std::filesystem::absolute(options.folders.front()).lexically_normal();
  const auto name = first.has_filename() ? first.filename() : first.parent_path().filename();
  return std::filesystem::path("results") / ("diagnosis-" + name.string());
}

DiagnosisRequest request_of(const DiagnoseOptions& options, const Document& document) {
  std::vector<Dataset> datasets;
  for (const auto& folder : options.folders) datasets.push_back(read_dataset(folder));
  DiagnosisRequest request = request_for(document, std::move(datasets));
  request.seed = options.seed;
  if (options.no_bootstrap) request.rules.bootstrap_draws = 0;
  if (options.no_fem && request.believed_fem)
    throw Error(ExitCode::bad_input, "the believed model is one of finite elements",
                {.key = "--no-fem", .allowed = "with a lumped model"});
  request.ask_fem = !options.no_fem;
  if (!options.mesh.empty()) {
    request.mesh_file = std::filesystem::absolute(options.mesh).string();
    for (const Dataset& dataset : request.datasets)  // refused before anything is fitted
      mesh_for(FemProblem{.sphere = dataset.sphere, .mesh_file = request.mesh_file});
  }
  request.hold_out = options.hold_out != "none";
  if (request.hold_out && !options.hold_out.empty()) try {
      request.held_out_speed = parse_quantity(options.hold_out, dimension::speed);
    } catch (const Error& error) {
      throw Error(
          error.code(), error.what(),
          {.key = "--hold-out", .value = options.hold_out, .allowed = "e.g. \"15 m/s\", or none"});
    }
  return request;
}

/// extended.toml of the first ball, extended-2.toml of the second and so on; those of an earlier
/// verdict go.
std::vector<std::string> write_extended_models(const Diagnosis& diagnosis,
                                               const std::filesystem::path& out) {
  for (const auto& entry : std::filesystem::directory_iterator(out))
    if (entry.path().filename().string().starts_with("extended") &&
        entry.path().extension() == ".toml")
      std::filesystem::remove(entry.path());
  std::vector<std::string> written;
  if (!diagnosis.gap.after) return written;
  for (std::size_t ball = 0; ball < diagnosis.seen->balls.size(); ++ball) {
    const auto file =
        out / (ball == 0 ? "extended.toml" : fmt::format("extended-{}.toml", ball + 1));
    write_file_atomically(file, extended_model_toml(diagnosis, ball));
    written.push_back(file.string());
  }
  return written;
}

ExitCode run_diagnose(const Session& session, const DiagnoseOptions& options) {
  const Document document = Document::load(options.model);
  const DiagnosisRequest request = request_of(options, document);
  const std::filesystem::path out = folder_for(session, options);
  make_writable_folder(out);
  Diagnosis diagnosis = [&] {
    ProgressLine progress("diagnosis");
    try {
      return diagnose(request, progress.control());
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  if (options.no_fem) diagnosis.warnings.push_back("finite elements were not asked (--no-fem)");
  const Provenance provenance = provenance_of(session, options.model, document.text());
  Json json = json_with_error_rates(diagnosis);
  const std::vector<std::string> extended = write_extended_models(diagnosis, out);
  if (!extended.empty()) json["extended_model"] = extended.front();
  json["extended_models"] = extended;
  report::write_report(diagnosis_report(diagnosis, request.datasets.front().name, provenance,
                                        error_rates_on_page(diagnosis)),
                       out / "report.html");
  json["report"] = (out / "report.html").string();
  Json stored = json;
  stored["provenance"] = to_json(provenance);
  write_file_atomically(out / "diagnosis.json", dump(stored));
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(fmt::format("{}{}report    {}\n", to_text(diagnosis), error_rates_text(diagnosis),
                           (out / "report.html").string()));
  const bool gap = diagnosis.verdict != DiagnosisVerdict::agrees &&
                   diagnosis.verdict != DiagnosisVerdict::insufficient_data;
  return options.fail_on_gap && gap ? ExitCode::comparison_failed : ExitCode::done;
}

}  // namespace

Action declare_diagnose(CLI::App& command) {
  const auto options = std::make_shared<DiagnoseOptions>();
  command.add_option("DATASET", options->folders, "Data-set folders, fitted jointly")->required();
  command.add_option("--model", options->model, "Impact file whose [model] is believed")
      ->required();
  command.add_option("--hold-out", options->hold_out,
                     "Speed that no fit sees, e.g. \"15 m/s\", or none; default: the middle one");
  command.add_option("--mesh", options->mesh,
                     "A mesh of your own (.msh, .geo, .step) where FE is asked: it and its "
                     "refinement, instead of 300 and 1200 cells");
  command.add_option("--seed", options->seed, "Seed of the draws behind the thresholds");
  command.add_flag("--no-bootstrap", options->no_bootstrap,
                   "Do not repeat the choice between candidates on data drawn anew");
  command.add_flag("--no-fem", options->no_fem,
                   "Do not ask finite elements: the lumped law's answer alone, sooner");
  command.add_flag("--fail-on-gap", options->fail_on_gap, "Exit 1 when model and data disagree");
  command.footer(diagnose_help);
  return [options](const Session& session) { return run_diagnose(session, *options); };
}

}  // namespace rebound
