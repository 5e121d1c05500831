#include "comparisons/discrepancy/inspection/inspection_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/results/key_words.hpp"

namespace rebound {
namespace {

using report::Origin;
using Kind = report::TableColumn::Kind;
using Verdict = report::TableCell::Verdict;

report::TableCell measured_cell(double value, const std::optional<double>& error) {
  if (error && *error > 0.0) return report::uncertain_cell(value, *error);
  return report::number_cell(value, 4);
}

/// A number of a shot by its key; nullptr where the shot has none.
const InspectedNumber* number_of(const InspectedShot& shot, const std::string& key) {
  for (const InspectedNumber& number : shot.numbers)
    if (number.key == key) return &number;
  return nullptr;
}

/// Keys of all numbers, in the order in which they first appear.
std::vector<std::string> keys_of(const Inspection& found) {
  std::vector<std::string> keys;
  for (const InspectedShot& shot : found.shots)
    for (const InspectedNumber& number : shot.numbers)
      if (std::find(keys.begin(), keys.end(), number.key) == keys.end()) keys.push_back(number.key);
  return keys;
}

}  // namespace

report::Table number_table(const Inspection& found) {
  report::Table table{
      .title = "Numbers of every shot",
      .caption =
          "Read off the record by the definitions of the diagnosis, or as stated. One "
          "standard deviation: noise of the samples in its size and colour, zero, and the "
          "width of a sample.",
      .columns = {{"shot"}},
      .rows = {}};
  const std::vector<std::string> keys = keys_of(found);
  for (const std::string& key : keys) {
    const KeyWords words = words_of_key(key);
    table.columns.push_back({words.quantity, words.unit.empty() ? "1" : words.unit, Kind::number,
                             key.starts_with("stated") ? Origin::measured : Origin::derived});
  }
  for (const InspectedShot& shot : found.shots) {
    std::vector<report::TableCell> row{report::text_cell(shot.label)};
    for (const std::string& key : keys) {
      const InspectedNumber* number = number_of(shot, key);
      row.push_back(number ? measured_cell(number->value, number->uncertainty)
                           : report::text_cell("-"));
    }
    table.rows.push_back(std::move(row));
  }
  if (keys.empty()) table.rows.clear();
  return table;
}

report::Table coarse_table(const Inspection& found) {
  report::Table table{.title = "Too coarse to use",
                      .caption = "What the record of a shot is no good for.",
                      .columns = {{"shot"}, {"why"}},
                      .rows = {}};
  for (const InspectedShot& shot : found.shots)
    for (const std::string& why : shot.too_coarse)
      table.rows.push_back({report::text_cell(shot.label), report::text_cell(why, Verdict::bad)});
  return table;
}

report::Table filter_table(const Inspection& found) {
  report::Table table{
      .title = "What a channel filter would do to the peak",
      .caption =
          "Phaseless filters of SAE J211, classes that the sampling allows. A filter that "
          "lowers the peak has also lengthened the contact.",
      .columns = {{"shot"}},
      .rows = {}};
  std::vector<double> classes;
  for (const InspectedShot& shot : found.shots)
    for (const FilteredPeak& one : shot.filters)
      if (std::find(classes.begin(), classes.end(), one.channel_class) == classes.end())
        classes.push_back(one.channel_class);
  std::sort(classes.begin(), classes.end());
  for (const double one : classes)
    table.columns.push_back({fmt::format("CFC {:g}", one), "%", Kind::number, Origin::derived});
  for (const InspectedShot& shot : found.shots) {
    if (shot.filters.empty()) continue;
    std::vector<report::TableCell> row{report::text_cell(shot.label)};
    for (const double one : classes) {
      const auto there =
          std::find_if(shot.filters.begin(), shot.filters.end(),
                       [&](const FilteredPeak& peak) { return peak.channel_class == one; });
      row.push_back(there == shot.filters.end()
                        ? report::text_cell("sampled too slowly")
                        : report::text_cell(fmt::format("{:+.2f}", 100.0 * there->change)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table data_check_table(const Inspection& found) {
  const double limit = found.contradiction_limit;
  report::Table table{
      .title = "The data against themselves",
      .caption = fmt::format("Found without any model of the contact. Beyond {:.1f} standard "
                             "deviations a check is a contradiction.",
                             limit),
      .columns = {{"check"},
                  {"of"},
                  {"measured", "as named", Kind::number, Origin::measured},
                  {"expected", "as named", Kind::number, Origin::derived},
                  {"deviation", "σ", Kind::number, Origin::derived},
                  {"mended by"}},
      .rows = {}};
  for (const DataCheck& one : found.checks)
    table.rows.push_back(
        {report::text_cell(one.what), report::text_cell(one.of),
         report::text_cell(fmt::format("{:.4g}{}", one.measured, behind_number(one.unit))),
         report::text_cell(fmt::format("{:.4g}{}", one.expected, behind_number(one.unit))),
         report::text_cell(fmt::format("{:+.1f}", one.deviations()),
                           std::abs(one.deviations()) > limit ? Verdict::bad : Verdict::good),
         report::text_cell(one.mended_by)});
  return table;
}

report::Table repeat_table(const Inspection& found) {
  report::Table table{
      .title = "Repeats",
      .caption =
          "Shots within 2 % of one speed. Scatter well above the stated error: something "
          "else changes from shot to shot; well below: the error is common to all shots, or "
          "is overstated.",
      .columns = {{"number"},
                  {"speed", "m/s", Kind::number},
                  {"shots", "1", Kind::number},
                  {"mean", "as named", Kind::number, Origin::derived},
                  {"scatter", "as named", Kind::number, Origin::derived},
                  {"stated error", "as named", Kind::number}},
      .rows = {}};
  for (const RepeatedSpeed& one : found.repeats) {
    const KeyWords words = words_of_key(one.key);
    const auto cell = [&](double value, int digits) {
      return report::text_cell(fmt::format("{:.{}g}{}", value, digits, behind_number(words.unit)));
    };
    table.rows.push_back(
        {report::text_cell(words.quantity), report::number_cell(one.speed, 4),
         report::text_cell(std::to_string(one.count)), cell(one.mean, 4), cell(one.scatter, 2),
         one.typical_error ? cell(*one.typical_error, 2) : report::text_cell("unknown")});
  }
  return table;
}

}  // namespace rebound
