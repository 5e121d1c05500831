#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/convert/code_conversion_text.hpp"
#include "comparisons/evaluation/convert/conversion_file.hpp"
#include "comparisons/evaluation/convert/conversion_text.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct ConvertOptions {
  std::string file, to, fem, step;
  std::vector<std::string> speeds;
};

std::string convert_help() {
  std::string codes;
  for (const OtherCode& code : other_codes())
    codes += fmt::format("  {:<12}{}\n", code.name, code.title);
  return "Keys of FILE (TOML):\n" + help_text<ConversionRequest>() +
         "\nEvery convention is given twice: by the formula its codes use, and matched so that the "
         "integrated law\nreturns restitution and contact time. Errors: restitution as a "
         "difference, time and force as a share.\n--out writes convert.json.\n\n"
         "--to CODE prints what one pastes into another code, the mass and speed it holds for, and "
         "its error over a\nrange of speeds against what was given and, with --fem, against FE:\n" +
         codes + "\n" + exit_code_help();
}

double in_si(const std::string& key, const std::string& text, const Dimension& dimension) {
  try {
    return parse_quantity(text, dimension);
  } catch (const Error& error) {
    throw Error(ExitCode::bad_input, error.what(),
                {.key = key, .value = text, .allowed = "a number and its unit"});
  }
}

void print_conversion(const Session& session, const std::string& path, const Document& document,
                      const Json& json, const std::string& text) {
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "convert.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(text);
}

/// What is asked of a code's lines, with FE impacts ready to be run.
CodeRequest code_request(const ConvertOptions& options, const RunControl& control) {
  CodeRequest request;
  for (const std::string& speed : options.speeds)
    request.speeds.push_back(in_si("--speeds", speed, dimension::speed));
  if (!options.step.empty()) request.step = in_si("--step", options.step, dimension::time);
  if (options.fem.empty()) return request;
  request.fem = read_fem_problem(Document::load(options.fem));
  FemProblem slowest = *request.fem;
  if (!request.speeds.empty())
    slowest.impact.speed = *std::min_element(request.speeds.begin(), request.speeds.end());
  request.run = fem_runner(mesh_for(slowest, control), slowest.sphere, control);
  return request;
}

ExitCode run_convert(const Session& session, const ConvertOptions& options) {
  for (const auto& [key, given] : {std::pair{"--fem", !options.fem.empty()},
                                   {"--step", !options.step.empty()},
                                   {"--speeds", !options.speeds.empty()}})
    if (given && options.to.empty())
      throw Error(ExitCode::bad_input, "this belongs to --to", {.key = key});
  const OtherCode* code = options.to.empty() ? nullptr : &other_code(options.to);
  const Document document = Document::load(options.file);
  ConversionRequest request;
  read_document(document, request);
  check_density(document, request.sphere);
  if (!session.out.empty()) make_writable_folder(session.out);
  try {
    if (code) {
      ProgressLine progress("convert");
      const CodeConversion conversion =
          convert_to_code(*code, request, code_request(options, progress.control()));
      print_conversion(session, options.file, document, to_json(*code, conversion),
                       to_text(*code, conversion));
    } else {
      const ConversionTable table = convert(request);
      print_conversion(session, options.file, document, to_json(request, table),
                       to_text(request, table));
    }
  } catch (const Error& error) {
    if (error.location().key.starts_with("--")) throw;
    throw document.located(error);
  }
  return ExitCode::done;
}

}  // namespace

Action declare_convert(CLI::App& command) {
  const auto options = std::make_shared<ConvertOptions>();
  command
      .add_option("FILE", options->file,
                  "Conversion file: a ball, a speed, and a contact in one convention")
      ->required();
  command.add_option("--to", options->to, "A code: print what one pastes into it");
  command.add_option("--speeds", options->speeds,
                     "With --to: speeds of the errors, as \"5 m/s\"; default: a third to five "
                     "thirds of the file's");
  command.add_option("--fem", options->fem,
                     "With --to: FE impact file of the same ball, for errors against FE");
  command.add_option("--step", options->step,
                     "With --to: time step of an engine that steps, as \"0.1 ms\"; default: a "
                     "500th of the contact");
  command.footer(convert_help);
  return [options](const Session& session) { return run_convert(session, *options); };
}

}  // namespace rebound
