#include "comparisons/io/dataset/read_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "comparisons/io/dataset/csv_table.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"

namespace rebound {
namespace {

/// Follows links, so that a link out of the folder is seen as what it is.
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

void note_left_out_line(Dataset& dataset, const std::filesystem::path& file,
                        const CsvTable& table) {
  if (table.left_out_line == 0) return;
  dataset.notes.push_back(
      fmt::format("{}: line {} has no line end, may be cut off, and is left out",
                  file.filename().string(), table.left_out_line));
}

void read_trace(const Document& document, Dataset& dataset, std::size_t number) {
  MeasuredImpact& shot = dataset.shots[number];
  const auto file =
      file_in_folder(document, fmt::format("shot[{}].trace", number), shot.trace_file);
  CsvTable table = read_csv(
      file,
      {.needed = {"time_s", "force_N"}, .optional = {"deflection_m"}, .increasing = "time_s"});
  note_left_out_line(dataset, file, table);
  constexpr std::size_t fewest_samples = 3;  // the shared scalar definitions need them
  if (table.columns[0].size() < fewest_samples)
    throw Error(ExitCode::bad_input, "a trace needs at least three samples",
                {.file = file.string()});
  Trace trace;
  trace.time = std::move(table.columns[0]);
  trace.force = std::move(table.columns[1]);
  if (table.columns.size() > 2) trace.deflection = std::move(table.columns[2]);
  shot.trace = std::move(trace);
}

void read_curve(const Document& document, Dataset& dataset, std::size_t number) {
  Quasistatic& test = dataset.quasistatic[number];
  const auto file =
      file_in_folder(document, fmt::format("quasistatic[{}].trace", number), test.trace_file);
  CsvTable table = read_csv(file, {.needed = {"deflection_m", "force_N"}, .optional = {}});
  note_left_out_line(dataset, file, table);
  test.curve = ForceDeflectionCurve{std::move(table.columns[0]), std::move(table.columns[1])};
}

void check_shot(const Document& document, const MeasuredImpact& shot, std::size_t number) {
  const std::string path = fmt::format("shot[{}]", number);
  bool anything = !shot.trace_file.empty();
  for (const ScalarQuantity& scalar : scalar_quantities) {
    const Measured& measured = shot.*scalar.measured;
    anything = anything || measured.value;
    if (measured.uncertainty && !measured.value)
      throw document.error_at(fmt::format("{}.{}_uncertainty", path, scalar.key),
                              fmt::format("an uncertainty without its {}", scalar.key));
  }
  if (!anything) throw document.error_at(path, "the shot has neither a trace nor a scalar");
}

void check_instrument(const Document& document, const Instrument& instrument) {
  for (const std::string& name : instrument.independent_scalars)
    if (std::none_of(scalar_quantities.begin(), scalar_quantities.end(),
                     [&](const ScalarQuantity& scalar) { return scalar.key == name; }))
      throw document.error_at("instrument.independent_scalars",
                              fmt::format("there is no scalar '{}'", name),
                              "restitution, contact_time, peak_force, peak_deflection, "
                              "mean_deflection");
}

void check_tests(const Document& document, const Dataset& dataset) {
  for (std::size_t i = 0; i < dataset.quasistatic.size(); ++i)
    if (dataset.quasistatic[i].trace_file.empty() && !dataset.quasistatic[i].stiffness.value)
      throw document.error_at(fmt::format("quasistatic[{}]", i),
                              "the compression has neither a trace nor a stiffness");
  for (std::size_t i = 0; i < dataset.block_tests.size(); ++i)
    if (!dataset.block_tests[i].modulus.value)
      throw document.error_at(fmt::format("block[{}]", i), "the block test has no modulus");
}

}  // namespace

Dataset read_dataset(const std::filesystem::path& folder) {
  const Document document = Document::load(folder / "dataset.toml");
  Dataset dataset;
  read_document(document, dataset);
  dataset.folder = folder.string();
  check_density(document, dataset.sphere);
  check_instrument(document, dataset.instrument);
  for (std::size_t i = 0; i < dataset.shots.size(); ++i) {
    check_shot(document, dataset.shots[i], i);
    if (!dataset.shots[i].trace_file.empty()) read_trace(document, dataset, i);
  }
  check_tests(document, dataset);
  for (std::size_t i = 0; i < dataset.quasistatic.size(); ++i)
    if (!dataset.quasistatic[i].trace_file.empty()) read_curve(document, dataset, i);
  return dataset;
}

}  // namespace rebound
