#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/plausibility.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/config/describe_lumped.hpp"
#include "comparisons/config/help_writer.hpp"
#include "comparisons/config/impact_file.hpp"
#include "comparisons/config/toml_writer.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/results/result_folder.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"

namespace rebound {
namespace {

std::string lumped_help() {
  std::string text = "Keys of FILE (TOML):\n" + help_text<LumpedImpactFile>() + "\nLaws:\n";
  for (const LawCard& law : all_laws())
    text += "  " + law.name + "\n      " + law.equation + "\n      " + law.source + "\n";
  return text + "\n" + exit_code_help();
}

LumpedResult simulate_located(const Document& document, const LumpedProblem& problem) {
  try {
    return simulate(problem);
  } catch (const Error& error) {
    throw document.located(error);
  }
}

ExitCode run_lumped(const Session& session, const std::string& file) {
  const Document document = Document::load(file);
  const LumpedImpactFile impact_file = read_lumped_impact(document);
  const LumpedProblem problem = applied(impact_file, document);
  if (!session.out.empty()) make_writable_folder(session.out);
  const LumpedResult result = simulate_located(document, problem);
  check_deflection(document, problem.sphere, result.scalars.peak_deflection);
  if (!session.out.empty())
    write_result({.folder = session.out,
                  .effective_toml = write_toml(impact_file),
                  .provenance = provenance_of(session, file, document.text())},
                 result);
  print_result(session, to_json(result));
  return ExitCode::done;
}

}  // namespace

Action declare_lumped(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Impact file with [model] tier = \"lumped\"")->required();
  command.footer(lumped_help);
  return [file](const Session& session) { return run_lumped(session, *file); };
}

}  // namespace rebound
