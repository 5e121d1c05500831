#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "comparisons/io/dataset/data_files.hpp"
#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// A number of a shot that a column may hold.
struct ColumnTarget {
  std::string key;
  Dimension dimension;
  std::function<void(MeasuredImpact&, double)> set;
};

std::vector<ColumnTarget> number_targets() {
  std::vector<ColumnTarget> targets{
      {"speed", dimension::speed,
       [](MeasuredImpact& shot, double value) { shot.impact.speed = value; }},
      {"speed_uncertainty", dimension::speed,
       [](MeasuredImpact& shot, double value) { shot.speed_uncertainty = value; }},
      {"repeats", dimension::none,
       [](MeasuredImpact& shot, double value) { shot.readings.repeats = value; }}};
  const Dimension of_scalar[] = {dimension::none, dimension::time, dimension::force,
                                 dimension::length, dimension::length};
  for (std::size_t i = 0; i < scalar_quantities.size(); ++i) {
    const auto member = scalar_quantities[i].measured;
    const std::string key = scalar_quantities[i].key;
    targets.push_back({key, of_scalar[i], [member](MeasuredImpact& shot, double value) {
                         (shot.*member).value = value;
                       }});
    targets.push_back(
        {key + "_uncertainty", of_scalar[i],
         [member](MeasuredImpact& shot, double value) { (shot.*member).uncertainty = value; }});
  }
  for (const ReadingQuantity& quantity : reading_quantities) {
    const auto member = quantity.member;
    const Dimension dimension = find_unit(quantity.unit).value_or(LaboratoryUnit{}).dimension;
    const std::string key = quantity.key;
    targets.push_back({key, dimension, [member](MeasuredImpact& shot, double value) {
                         (shot.readings.*member).value = value;
                       }});
    targets.push_back(
        {key + "_uncertainty", dimension, [member](MeasuredImpact& shot, double value) {
           (shot.readings.*member).uncertainty = value;
         }});
  }
  return targets;
}

/// The columns of a table that are wanted, in this order: those of `targets`, the file names, what
/// rows are selected by.
struct Layout {
  std::vector<WantedColumn> wanted;
  std::vector<ColumnTarget> targets;
  std::size_t trace = 0, only = 0;  ///< place in `wanted`; 0 where there is none
};

Layout layout_of(const ShotTable& table) {
  Layout layout;
  for (ColumnTarget& target : number_targets())
    if (const auto heading = table.columns.find(target.key); heading != table.columns.end()) {
      layout.wanted.push_back({.heading = heading->second, .accepted = {target.dimension}});
      layout.targets.push_back(std::move(target));
    }
  const auto text_column = [&](const std::string& heading) {
    layout.wanted.push_back({.heading = heading, .accepted = {}});
    return layout.wanted.size() - 1;
  };
  if (const auto trace = table.columns.find("trace"); trace != table.columns.end())
    layout.trace = text_column(trace->second);
  if (!table.only_column.empty()) layout.only = text_column(table.only_column);
  return layout;
}

void apply_relative(const ShotTable& table, MeasuredImpact& shot) {
  if (table.speed_relative_uncertainty && !shot.speed_uncertainty)
    shot.speed_uncertainty = *table.speed_relative_uncertainty * shot.impact.speed;
  if (table.restitution_relative_uncertainty && shot.restitution.value)
    shot.restitution.uncertainty =
        *table.restitution_relative_uncertainty * *shot.restitution.value;
}

[[noreturn]] void refuse_row(const std::filesystem::path& file, int line, const Error& error) {
  ErrorLocation at = error.location();
  at.file = file.string();
  at.line = line;
  at.column = 0;
  throw Error(error.code(), error.what(), at);
}

void need_positive(const WantedColumn& wanted, double value) {
  if (value > 0.0) return;
  throw Error(ExitCode::bad_input, "the value must be positive",
              {.key = wanted.heading, .value = fmt::format("{:.6g}", value)});
}

void read_shot_table(const Document& document, Dataset& dataset, std::size_t number) {
  const ShotTable& table = dataset.shot_tables[number];
  const std::string key = fmt::format("shot_table[{}]", number);
  if (table.only_column.empty() != table.only.empty())
    throw document.error_at(key, "only_column and only stand together or not at all");
  const Layout layout = layout_of(table);
  if (layout.targets.empty())
    throw document.error_at(key + ".columns", "no column holds a number of a shot");
  const auto file = file_in_folder(document, key + ".file", table.file);
  const LaboratoryTable rows = read_laboratory_table(file, layout.wanted);
  note_left_out_line(dataset, file, rows.left_out_line);
  std::size_t taken = 0;
  for (std::size_t row = 0; row < rows.lines.size(); ++row) {
    if (layout.only > 0 && rows.columns[layout.only].texts[row] != table.only) continue;
    ++taken;
    MeasuredImpact shot = table.common;
    try {
      for (std::size_t i = 0; i < layout.targets.size(); ++i) {
        const double value = rows.columns[i].numbers[row];
        need_positive(layout.wanted[i], value);
        layout.targets[i].set(shot, value);
      }
      if (layout.trace > 0) shot.trace_file = rows.columns[layout.trace].texts[row];
      if (!shot.trace_file.empty()) read_trace(document, dataset, shot, key);
      settle_shot(document, dataset, shot, key);
    } catch (const Error& error) {
      if (error.location().file == document.name() || error.location().file.empty())
        refuse_row(file, rows.lines[row], error);
      throw;
    }
    apply_relative(table, shot);
    dataset.shots.push_back(std::move(shot));
  }
  if (taken == 0)
    throw document.error_at(key + ".only", "no row of the table is meant",
                            fmt::format("what stands in the column {}", table.only_column));
}

}  // namespace

void read_shot_tables(const Document& document, Dataset& dataset) {
  for (std::size_t i = 0; i < dataset.shot_tables.size(); ++i)
    read_shot_table(document, dataset, i);
  dataset.shot_tables.clear();
}

void settle_shot(const Document& document, const Dataset& dataset, MeasuredImpact& shot,
                 const std::string& key) {
  const bool corrected = dataset.air.drag == AirDrag::corrected;
  try {
    settle_readings(shot, corrected ? FreeFall(dataset.sphere, dataset.air.air()) : FreeFall());
  } catch (const Error& error) {
    ErrorLocation at = document.error_at(key, "").location();
    at.key = key + "." + error.location().key;
    at.value = error.location().value;
    at.allowed = error.location().allowed;
    throw Error(error.code(), error.what(), at);
  }
}

}  // namespace rebound
