#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/discrepancy/design/design_output.hpp"
#include "comparisons/io/report/write_report.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

ExitCode run_design(const Session& session, const std::string& path, std::uint64_t seed) {
  const Document document = Document::load(path);
  const SynthesisFile plan = read_synthesis(document);
  if (!session.out.empty()) make_writable_folder(session.out);
  TestDesign design;
  {
    ProgressLine progress("design of a test");
    const RunControl control = progress.control();
    document.locating([&] { design = design_test(plan, seed, control); });
  }
  Json json = to_json(design);
  if (!session.out.empty()) {
    report::write_report(design_report(design, plan.name), session.out / "report.html");
    json["report"] = (session.out / "report.html").string();
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "design.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(design));
  return ExitCode::done;
}

}  // namespace

Action declare_design(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "Synthesis file of the lumped tier without effects: the plan")
      ->required();
  const auto seed = std::make_shared<std::uint64_t>(1);
  command.add_option("--seed", *seed, "Seed of the draws behind the threshold");
  command.footer(
      "Says, before a test is made, which missing effects it would find and from which size on,\n"
      "which it could not tell apart, and what change of the plan would help most. FILE is what\n"
      "`rebound synthesize` takes, with no effect in it: ball, law, speeds, repeats, instrument.\n"
      "--out DIR writes report.html and design.json.\n\n"
      "Keys of FILE (TOML):\n" +
      help_text<SynthesisFile>() + "\n" + exit_code_help());
  return [=](const Session& session) { return run_design(session, *file, *seed); };
}

}  // namespace rebound
