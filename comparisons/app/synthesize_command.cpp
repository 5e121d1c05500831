#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/discrepancy/synthesis/truth.hpp"
#include "comparisons/io/dataset/write_dataset.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct SynthesizeOptions {
  std::string file;
  std::string truth_file;
  bool sealed = false;
};

std::string synthesize_help() {
  return "Keys of FILE (TOML):\n" + help_text<SynthesisFile>() +
         "\nWrites the data set to DIR/data and the truth to DIR/truth.json, DIR being --out. With "
         "--seal\nDIR/seal.json holds the SHA-256 of the truth instead, and the truth goes where "
         "--truth says.\nA plain impact file is a synthesis file as well.\n\n" +
         exit_code_help();
}

Synthesis make(const Document& document, const SynthesisFile& file) {
  ProgressLine progress("synthetic experiment");
  const RunControl control = progress.control();
  try {
    return synthesize(file, simulator_of(file, control), control);
  } catch (const Error& error) {
    throw document.located(error);
  }
}

ExitCode run_synthesize(const Session& session, const SynthesizeOptions& options) {
  if (session.out.empty())
    throw Error(ExitCode::bad_input, "a synthetic experiment needs a folder to go to: give --out");
  if (options.sealed != !options.truth_file.empty())
    throw Error(ExitCode::bad_input,
                "--seal and --truth FILE belong together: a sealed truth needs "
                "a place of its own");
  const Document document = Document::load(options.file);
  const SynthesisFile file = read_synthesis(document);
  make_writable_folder(session.out);
  const Synthesis made = make(document, file);
  const Provenance provenance = file.tier == Tier::fem
                                    ? provenance_with_fem(session, options.file, document.text())
                                    : provenance_of(session, options.file, document.text());
  Json truth = truth_json(file, document.text(), made);
  truth["provenance"] = to_json(provenance);

  Json printed = {{"schema", 1},
                  {"data", (session.out / "data").string()},
                  {"shots", made.dataset.shots.size()},
                  {"seed", file.seed}};
  if (options.sealed) {
    const SealedTruth sealed = seal(std::move(truth));
    write_file_atomically(options.truth_file, sealed.truth);
    write_file_atomically(session.out / "seal.json", sealed.seal);
    printed["seal"] = (session.out / "seal.json").string();
  } else {
    write_file_atomically(session.out / "truth.json", dump(truth));
    printed["truth"] = (session.out / "truth.json").string();
  }
  write_dataset(made.dataset, session.out / "data");
  print_result(session, printed);
  return ExitCode::done;
}

}  // namespace

Action declare_synthesize(CLI::App& command) {
  const auto options = std::make_shared<SynthesizeOptions>();
  command
      .add_option("FILE", options->file, "Synthesis file: a model, effects, an instrument, shots")
      ->required();
  command.add_flag("--seal", options->sealed, "Keep the truth out of --out; leave its hash there");
  command.add_option("--truth", options->truth_file, "Where a sealed truth goes");
  command.footer(synthesize_help);
  return [options](const Session& session) { return run_synthesize(session, *options); };
}

}  // namespace rebound
