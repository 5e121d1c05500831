#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "comparisons/io/dataset/data_files.hpp"
#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "comparisons/io/laboratory/row_window.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::string or_else(const std::string& heading, const char* usual) {
  return heading.empty() ? usual : heading;
}

WantedColumn wanted_force(const TraceChannels& channels, const MeasuredImpact& shot) {
  if (!shot.channel.empty())
    return {.heading = shot.channel,
            .accepted = {dimension::force, dimension::acceleration},
            .unit = channels.force_unit};
  if (!channels.acceleration.empty())
    return {.heading = channels.acceleration,
            .accepted = {dimension::acceleration},
            .unit = channels.force_unit};
  return {.heading = or_else(channels.force, "force"),
          .accepted = {dimension::force},
          .unit = channels.force_unit};
}

/// Of a record of any length: a contact and its quiet are far shorter.
constexpr KeptRows kept_rows = rows_of_a_record(1);

}  // namespace

std::filesystem::path file_in_folder(const Document& document, const std::string& key,
                                     const std::string& written) {
  std::error_code status;
  const auto folder = std::filesystem::weakly_canonical(document.folder(), status);
  auto file = std::filesystem::weakly_canonical(folder / written, status);
  const auto relative = file.lexically_relative(folder);
  if (std::filesystem::path(written).is_absolute() || relative.empty() || *relative.begin() == "..")
    throw document.error_at(key, "the file lies outside the data set's folder",
                            "a file in the folder of dataset.toml");
  if (!std::filesystem::exists(file, status)) {
    const ErrorLocation at = document.error_at(key, "").location();
    throw Error(ExitCode::input_output_failed, "there is no such file in the data set's folder",
                at);
  }
  return file;
}

void note_left_out_line(Dataset& dataset, const std::filesystem::path& file, int line) {
  if (line == 0) return;
  const std::string note =
      fmt::format("{}: line {} has no line end, may be cut off, and is left out",
                  file.filename().string(), line);
  for (const std::string& known : dataset.notes)
    if (known == note) return;
  dataset.notes.push_back(note);
}

void read_trace(const Document& document, Dataset& dataset, MeasuredImpact& shot,
                const std::string& key) {
  const TraceChannels& channels = dataset.channels;
  const auto file = file_in_folder(document, key + ".trace", shot.trace_file);
  LaboratoryTable table =
      read_laboratory_table(file,
                            {{.heading = or_else(channels.time, "time"),
                              .accepted = {dimension::time},
                              .increases = true,
                              .unit = channels.time_unit},
                             wanted_force(channels, shot),
                             {.heading = or_else(channels.deflection, "deflection"),
                              .accepted = {dimension::length},
                              .unit = channels.deflection_unit,
                              .is_optional = channels.deflection.empty()}},
                            kept_rows);
  note_left_out_line(dataset, file, table.left_out_line);
  if (table.rows_read > table.lines.size())
    dataset.notes.push_back(fmt::format(
        "{}: of {} rows those from line {} to {} are kept, around the largest force",
        file.filename().string(), table.rows_read, table.lines.front(), table.lines.back()));
  constexpr std::size_t fewest_samples = 3;  // the shared scalar definitions need them
  if (table.lines.size() < fewest_samples)
    throw Error(ExitCode::bad_input, "a trace needs at least three samples",
                {.file = file.string()});
  Trace trace;
  trace.time = std::move(table.columns[0].numbers);
  trace.force = std::move(table.columns[1].numbers);
  trace.deflection = std::move(table.columns[2].numbers);
  if (same_dimension(table.columns[1].dimension, dimension::acceleration))
    for (double& force : trace.force) force *= dataset.sphere.mass;
  try {
    settle_record(channels, trace);
  } catch (const Error& error) {
    ErrorLocation at = error.location();
    at.file = file.string();
    throw Error(error.code(), error.what(), at);
  }
  shot.trace = std::move(trace);
}

void read_curve(const Document& document, Dataset& dataset, std::size_t number) {
  Quasistatic& test = dataset.quasistatic[number];
  const auto file =
      file_in_folder(document, fmt::format("quasistatic[{}].trace", number), test.trace_file);
  LaboratoryTable table =
      read_laboratory_table(file, {{.heading = "deflection", .accepted = {dimension::length}},
                                   {.heading = "force", .accepted = {dimension::force}}});
  note_left_out_line(dataset, file, table.left_out_line);
  test.curve = ForceDeflectionCurve{std::move(table.columns[0].numbers),
                                    std::move(table.columns[1].numbers)};
}

}  // namespace rebound
