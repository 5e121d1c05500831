#include "comparisons/io/dataset/guess_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "comparisons/io/dataset/guess_trace.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr const char* guessed_mark = "# GUESSED";

std::string entry(const std::string& key, const std::string& value, const std::string& comment) {
  const std::string pair = fmt::format("{} = {}", key, toml_string(value));
  return comment.empty() ? pair + "\n" : fmt::format("{:<44} {}\n", pair, comment);
}

std::string sphere_section(const DatasetHints& hints) {
  const auto line = [](const char* key, const std::string& said, const char* what) {
    return said.empty() ? entry(key, "?", fmt::format("# TO BE FILLED IN: {}", what))
                        : entry(key, said, "");
  };
  return "[sphere]\n" + line("mass", hints.mass, "of the ball, e.g. \"89.6 g\"") +
         line("diameter", hints.diameter, "of the ball, e.g. \"66.2 mm\"") +
         "# mass_uncertainty = \"0.4 g\"\n# diameter_uncertainty = \"0.1 mm\"\n\n";
}

std::string head_of(const std::filesystem::path& file, const TablePreview& preview) {
  const std::string marks = fmt::format(
      "# Written for {} by `rebound init dataset --from`. Lines marked GUESSED were guessed from\n"
      "# names, units and numbers: look at each, then take the mark away. \"?\" is to be filled "
      "in.\n",
      file.filename().string());
  const std::string rest = fmt::format(
      "# All keys: rebound schema dataset. Then: rebound inspect FOLDER.\n"
      "schema = 1\nname = {}\n",
      toml_string(file.stem().string()));
  if (preview.heading_line == 0)
    return fmt::format("{}# The file: {} variables, the longest of {} numbers.\n{}", marks,
                       preview.headings.size(), preview.rows, rest);
  const char* separator = preview.dialect.separator == '\t'  ? "tabulators"
                          : preview.dialect.separator == ';' ? "semicolons"
                                                             : "commas";
  return fmt::format("{}# The file: heading in line {}, {} rows, parted by {}, decimal {}.\n{}",
                     marks, preview.heading_line, preview.rows, separator,
                     preview.dialect.decimal_mark == ',' ? "comma" : "point", rest);
}

std::string channels_section(const TablePreview& preview, const TraceGuess& trace,
                             const RecordGuess& record) {
  std::string text;
  for (const std::string& remark : trace.remarks) text += "# not used, " + remark + "\n";
  text += "[channels]\n";
  std::string units;
  const auto add = [&](const char* key, const char* unit_key, const ChannelGuess& channel) {
    text += entry(key, preview.headings[channel.column].text, guessed_mark);
    if (channel.unit_guessed)
      units += entry(unit_key, usual_unit(channel.dimension),
                     fmt::format("{}: the heading states no unit", guessed_mark));
  };
  add("time", "time_unit", trace.time);
  const ChannelGuess& force = trace.forces.front();
  add(same_dimension(force.dimension, dimension::force) ? "force" : "acceleration", "force_unit",
      force);
  if (trace.deflection) add("deflection", "deflection_unit", *trace.deflection);
  text += units;
  if (record.reversed)
    text +=
        fmt::format("{:<44} {}: the largest swing is downwards\n", "reversed = true", guessed_mark);
  if (record.offset)
    text += entry("baseline", "before-contact",
                  fmt::format("{}: the start of the record is off zero", guessed_mark));
  if (record.long_record)
    text += entry("keep", "around-contact",
                  fmt::format("{}: the contact is a small part of the record", guessed_mark));
  return text + "\n";
}

std::string trace_manifest(const std::filesystem::path& file, const TablePreview& preview,
                           const TraceGuess& trace, const DatasetHints& hints) {
  std::string text =
      head_of(file, preview) + "\n" + sphere_section(hints) +
      "[instrument]\n# force_gain_uncertainty = 0.02\n# force_bandwidth = \"20 kHz\"\n";
  if (trace.deflection)
    text += entry("deflection", "unknown",
                  "# TO BE SAID: independent (an instrument of its own) or integrated");
  text += "\n" + channels_section(preview, trace, look_at_record(file, preview, trace));
  for (const ChannelGuess& channel : trace.forces) {
    text += "[[shot]]\n";
    text += hints.speed.empty() ? entry("speed", "?", "# TO BE FILLED IN: e.g. \"15 m/s\"")
                                : entry("speed", hints.speed, "");
    text += entry("trace", file.filename().string(), "");
    if (trace.forces.size() > 1)
      text += entry("channel", preview.headings[channel.column].text,
                    fmt::format("{}: one shot a channel", guessed_mark));
    text += "# restitution = 0.5\n# restitution_uncertainty = 0.01\n\n";
  }
  return text;
}

std::string table_manifest(const std::filesystem::path& file, const TablePreview& preview,
                           const GuessedColumns& columns, const std::string& ball,
                           const DatasetHints& hints) {
  std::string text = head_of(file, preview) + "\n" + sphere_section(hints);
  if (columns.by_key.contains("rebound_height") || columns.by_key.contains("flight_time"))
    text += "# [air]\n# drag = \"corrected\"\n# drag_coefficient = 0.5\n\n";
  text += "[[shot_table]]\n" + entry("file", file.filename().string(), "");
  if (columns.ball >= 0) {
    const auto& heading = preview.headings[static_cast<std::size_t>(columns.ball)].text;
    text += entry("only_column", heading, guessed_mark) + entry("only", ball, guessed_mark);
  }
  text += "# restitution_relative_uncertainty = 0.02\n# speed_relative_uncertainty = 0.01\n";
  for (const std::string& remark : columns.remarks) text += "# not used, " + remark + "\n";
  text += "[shot_table.columns]\n";
  for (const auto& [key, column] : columns.by_key)
    text += entry(key, preview.headings[column].text, guessed_mark);
  return text;
}

/// Names of the balls in the order in which they stand in the file.
std::vector<std::string> balls_in(const std::filesystem::path& file, const TablePreview& preview,
                                  const GuessedColumns& columns) {
  if (columns.ball < 0) return {""};
  const auto& heading = preview.headings[static_cast<std::size_t>(columns.ball)].text;
  const LaboratoryTable table = read_laboratory_table(file, {{.heading = heading, .accepted = {}}});
  std::vector<std::string> balls;
  for (const std::string& ball : table.columns[0].texts)
    if (std::find(balls.begin(), balls.end(), ball) == balls.end()) balls.push_back(ball);
  constexpr std::size_t most_balls = 100;
  if (balls.size() > most_balls)
    throw Error(ExitCode::bad_input,
                fmt::format("the column names {} balls; {} are the most", balls.size(), most_balls),
                {.file = file.string(), .line = preview.heading_line, .key = heading});
  return balls;
}

std::string folder_of(const std::string& ball) {
  std::string name = "ball-";
  for (const char sign : ball) name += std::isalnum(static_cast<unsigned char>(sign)) ? sign : '-';
  return name;
}

}  // namespace

std::vector<GuessedDataset> guess_dataset(const std::filesystem::path& file,
                                          const DatasetHints& hints) {
  const TablePreview preview = preview_table(file);
  if (const auto trace = guess_trace(preview))
    return {{"", trace_manifest(file, preview, *trace, hints)}};
  const GuessedColumns columns = guess_shot_columns(preview);
  if (columns.by_key.empty())
    throw Error(ExitCode::bad_input,
                "no column looks like a force, an acceleration, a speed, a height or a time of an "
                "impact",
                {.file = file.string(),
                 .line = preview.heading_line,
                 .key = {},
                 .value = {},
                 .allowed = "headings with units, e.g. time [ms], force [kN]; drop [cm], rebound "
                            "[cm]; speed [m/s], rebound speed [m/s]"});
  std::vector<GuessedDataset> datasets;
  const auto balls = balls_in(file, preview, columns);
  datasets.reserve(balls.size());
  for (const std::string& ball : balls)
    datasets.push_back({balls.size() == 1 ? "" : folder_of(ball),
                        table_manifest(file, preview, columns, ball, hints)});
  return datasets;
}

}  // namespace rebound
