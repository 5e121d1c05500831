#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/plausibility.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/io/results/result_folder.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/integration/sensitivities.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/law_card.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string lumped_help() {
  std::string text = "Keys of FILE (TOML):\n" + help_text<LumpedImpactFile>() + "\nLaws:\n";
  for (const LawCard& law : all_laws())
    text += "  " + law.name + "\n      " + law.equation + "\n      " + law.source + "\n";
  return text + "\n" + exit_code_help();
}

/// Derivatives in SI over SI, by parameter, mass and speed.
Json sensitivity_table(const LumpedProblem& problem) {
  const Sensitivities found = sensitivities(problem);
  Json table = Json::object();
  for (std::size_t i = 0; i < found.by.size(); ++i)
    table[found.by[i]] = {{"restitution", found.slopes[i].restitution},
                          {"contact_time_s", found.slopes[i].contact_time},
                          {"peak_force_N", found.slopes[i].peak_force},
                          {"peak_deflection_m", found.slopes[i].peak_deflection}};
  return table;
}

template <class Run>
auto located(const Document& document, const Run& run) {
  try {
    return run();
  } catch (const Error& error) {
    throw document.located(error);
  }
}

enum class Derivatives { none, printed };

ExitCode run_lumped(const Session& session, const std::string& file, Derivatives derivatives) {
  const Document document = Document::load(file);
  const LumpedImpactFile impact_file = read_lumped_impact(document);
  const LumpedProblem problem =
      applied({.problem = impact_file.problem, .effects = without_measurement(impact_file.effects)},
              document);
  if (!session.out.empty()) make_writable_folder(session.out);
  const LumpedResult result = located(document, [&] { return simulate(problem); });
  check_deflection(document, problem.sphere, result.scalars.peak_deflection);
  Json json = to_json(result);
  if (derivatives == Derivatives::printed)
    json["sensitivities"] = located(document, [&] { return sensitivity_table(problem); });
  if (!session.out.empty())
    write_result({.folder = session.out,
                  .effective_toml = write_toml(impact_file),
                  .provenance = provenance_of(session, file, document.text())},
                 result);
  print_result(session, json);
  return ExitCode::done;
}

}  // namespace

Action declare_lumped(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Impact file with [model] tier = \"lumped\"")->required();
  const auto derivatives = std::make_shared<bool>(false);
  command.add_flag("--sensitivities", *derivatives,
                   "Derivatives of restitution, contact time and peaks by every parameter of the "
                   "law, the mass and the speed (SI over SI); a law without effects");
  command.footer(lumped_help);
  return [=](const Session& session) {
    return run_lumped(session, *file, *derivatives ? Derivatives::printed : Derivatives::none);
  };
}

}  // namespace rebound
