#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/models/installation.hpp"
#include "comparisons/studies/reproduce/report_sections.hpp"
#include "comparisons/studies/reproduce/reproduction.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string reproduce_help() {
  return "Recomputes Tables 2 to 5 and the numbers of the text from the other printed numbers.\n"
         "Every input carries half a unit of its last printed digit. Verdicts:\n"
         "  reproduces       computed from the inputs as printed, rounds to the published digits\n"
         "  within-rounding  some inputs that would have been printed the same give them\n"
         "  differs          none do\n"
         "--out DIR writes reproduce.json and report.html.\n\n" +
         exit_code_help();
}

ExitCode run_reproduce(const Session& session, const std::string& data) {
  if (!session.out.empty()) make_writable_folder(session.out);
  const std::filesystem::path folder = data.empty() ? data_folder() : std::filesystem::path(data);
  const Reproduction reproduction = reproduce(folder);
  Json json = to_json(reproduction);
  if (!session.out.empty()) {
    report::write_report(reproduction_report(reproduction), session.out / "report.html");
    json["provenance"] = to_json(provenance_of(session, folder.string(), paper_text(folder)));
    write_file_atomically(session.out / "reproduce.json", dump(json));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(reproduction));
  return ExitCode::done;
}

}  // namespace

Action declare_reproduce(CLI::App& command) {
  const auto data = std::make_shared<std::string>();
  command.add_option("--data", *data,
                     "Folder with the paper's data; default: that which came with the sources");
  command.footer(reproduce_help);
  return [data](const Session& session) { return run_reproduce(session, *data); };
}

}  // namespace rebound
