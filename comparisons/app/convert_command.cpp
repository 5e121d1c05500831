#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/evaluation/convert/conversion_file.hpp"
#include "comparisons/evaluation/convert/conversion_text.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::string convert_help() {
  return "Keys of FILE (TOML):\n" + help_text<ConversionRequest>() +
         "\nEvery convention is given twice: by the formula its codes use, and matched so that the "
         "integrated law\nreturns restitution and contact time. Errors: restitution as a "
         "difference, time and force as a share.\n--out writes convert.json.\n\n" +
         exit_code_help();
}

ExitCode run_convert(const Session& session, const std::string& path) {
  const Document document = Document::load(path);
  ConversionRequest request;
  read_document(document, request);
  check_density(document, request.sphere);
  if (!session.out.empty()) make_writable_folder(session.out);
  const ConversionTable table = [&] {
    try {
      return convert(request);
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  const Json json = to_json(request, table);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "convert.json", dump(stored));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else
    print_text(to_text(request, table));
  return ExitCode::done;
}

}  // namespace

Action declare_convert(CLI::App& command) {
  const auto file = std::make_shared<std::string>();
  command
      .add_option("FILE", *file,
                  "Conversion file: a ball, a speed, and a contact in one convention")
      ->required();
  command.footer(convert_help);
  return [file](const Session& session) { return run_convert(session, *file); };
}

}  // namespace rebound
