#include "comparisons/io/dataset/read_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "comparisons/io/dataset/data_files.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"

namespace rebound {
namespace {

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
  if (!anything && !shot.readings.any())
    throw document.error_at(path, "the shot has neither a trace nor a scalar");
  for (const ReadingQuantity& quantity : reading_quantities) {
    const Reading& reading = shot.readings.*quantity.member;
    if (reading.uncertainty && !reading.value)
      throw document.error_at(fmt::format("{}.{}_uncertainty", path, quantity.key),
                              fmt::format("an uncertainty without its {}", quantity.key));
  }
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

void check_channels(const Document& document, const TraceChannels& channels) {
  if (!channels.force.empty() && !channels.acceleration.empty())
    throw document.error_at("channels.acceleration",
                            "a force and an acceleration that stands for it are both named");
}

/// Says once how much the air changes what was read off heights and times.
void note_air(Dataset& dataset) {
  double most = 0.0;
  for (const MeasuredImpact& shot : dataset.shots)
    most = std::max(most, change_by_air(shot, dataset.sphere, dataset.air.air()));
  constexpr double worth_a_word = 1e-5;
  if (most < worth_a_word) return;
  const Air air = dataset.air.air();
  const std::string note = fmt::format(
      "air drag {} heights and flight times: {} restitutions by up to {:.2g}, with a drag "
      "coefficient of {:g} in air of {:g} kg/m^3",
      dataset.air.drag == AirDrag::corrected ? "is taken out of" : "is not taken out of",
      dataset.air.drag == AirDrag::corrected ? "this raises" : "this would raise", most,
      air.drag_coefficient, air.density);
  if (std::find(dataset.notes.begin(), dataset.notes.end(), note) == dataset.notes.end())
    dataset.notes.push_back(note);
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

/// The folder in it that holds a data set, the first by name; empty where none does.
std::string data_set_within(const std::filesystem::path& folder) {
  std::error_code status;
  std::string first;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status)) {
    const std::string name = entry.path().filename().string();
    if (std::filesystem::exists(entry.path() / "dataset.toml", status) &&
        (first.empty() || name < first))
      first = name;
  }
  return first;
}

Error no_data_set(const std::filesystem::path& folder) {
  std::error_code status;
  std::string message =
      "there is no such folder: `rebound init dataset --from FILE` makes a data set";
  if (std::filesystem::is_directory(folder, status)) {
    const std::string within = data_set_within(folder);
    message =
        within.empty()
            ? "this folder holds no dataset.toml: `rebound init dataset --from FILE` makes one"
            : "this folder holds no dataset.toml; did you mean " + (folder / within).string() + "?";
  } else if (std::filesystem::exists(folder, status)) {
    message = "a data set is a folder: `rebound init dataset --from FILE` makes one of a file";
  }
  return {ExitCode::input_output_failed, message, {.file = folder.string()}};
}

}  // namespace

Dataset read_dataset(const std::filesystem::path& folder) {
  std::error_code status;
  if (!std::filesystem::exists(folder / "dataset.toml", status)) throw no_data_set(folder);
  const Document document = Document::load(folder / "dataset.toml");
  Dataset dataset;
  read_document(document, dataset);
  dataset.folder = folder.string();
  check_density(document, dataset.sphere);
  check_instrument(document, dataset.instrument);
  check_channels(document, dataset.channels);
  for (std::size_t i = 0; i < dataset.shots.size(); ++i) {
    check_shot(document, dataset.shots[i], i);
    const std::string key = fmt::format("shot[{}]", i);
    if (!dataset.shots[i].trace_file.empty()) read_trace(document, dataset, dataset.shots[i], key);
    settle_shot(document, dataset, dataset.shots[i], key);
  }
  read_shot_tables(document, dataset);
  note_air(dataset);
  check_tests(document, dataset);
  for (std::size_t i = 0; i < dataset.quasistatic.size(); ++i)
    if (!dataset.quasistatic[i].trace_file.empty()) read_curve(document, dataset, i);
  return dataset;
}

}  // namespace rebound
