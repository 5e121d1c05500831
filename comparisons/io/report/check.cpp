#include "comparisons/io/report/check.hpp"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

/// Carries the path to the block in hand, e.g. "report, section "Overlay", figure "F(x)"".
struct Place {
  std::string path;

  Place inside(const std::string& what, const std::string& name) const {
    return {path + ", " + what + " \"" + name + "\""};
  }
  void require(bool holds, const std::string& otherwise) const {
    if (!holds) throw Error(ExitCode::bad_input, path + ": " + otherwise);
  }
};

void check_axis(const Place& place, const Axis& axis, const char* name) {
  place.require(!axis.quantity.empty(), std::string(name) + " axis has no quantity");
  place.require(!axis.unit.empty(),
                std::string(name) + " axis has no unit (\"1\" is dimensionless)");
}

void check_numbers(const Place& place, const std::vector<double>& values, const char* name) {
  for (const double value : values) {
    place.require(std::isfinite(value), std::string(name) + " holds a number that is not finite");
  }
}

void check_optional_length(const Place& place, const Series& series,
                           const std::vector<double>& values, const char* name) {
  place.require(values.empty() || values.size() == series.x.size(),
                std::string(name) + " is not as long as x");
  check_numbers(place, values, name);
}

void check_series(const Place& place, const Series& series) {
  place.require(!series.x.empty(), "no points");
  place.require(series.x.size() == series.y.size(), "y is not as long as x");
  check_numbers(place, series.x, "x");
  check_numbers(place, series.y, "y");
  check_optional_length(place, series, series.x_error, "x_error");
  check_optional_length(place, series, series.y_error, "y_error");
  check_optional_length(place, series, series.y_low, "y_low");
  check_optional_length(place, series, series.y_high, "y_high");
  place.require(series.y_low.size() == series.y_high.size(), "a band needs y_low and y_high");
  for (std::size_t i = 0; i < series.y_low.size(); ++i) {
    place.require(series.y_low[i] <= series.y[i] && series.y[i] <= series.y_high[i],
                  "the band does not enclose the line");
  }
  place.require(series.origin != Origin::measured || series.style == Series::Style::points,
                "a measured series is drawn as points, never as a line");
}

void check_logarithmic(const Place& place, const Axis& axis, const std::vector<double>& values) {
  if (axis.spacing == Axis::Spacing::linear) return;
  for (const double value : values) {
    place.require(value > 0.0, "a number on a logarithmic axis is not positive");
  }
}

void check_figure(const Place& outside, const Figure& figure) {
  const Place place = outside.inside("figure", figure.title);
  place.require(!figure.title.empty(), "no title");
  check_axis(place, figure.x, "x");
  check_axis(place, figure.y, "y");
  place.require(!figure.series.empty(), "no series");
  std::set<std::string> names;
  for (const Series& series : figure.series) {
    place.require(!series.name.empty(), "a series has no name");
    place.require(names.insert(series.name).second, "two series are named \"" + series.name + "\"");
    const Place at = place.inside("series", series.name);
    check_series(at, series);
    check_logarithmic(at, figure.x, series.x);
    check_logarithmic(at, figure.y, series.y);
  }
}

void check_fields(const Place& place, const Animation& animation) {
  for (const AnimationField& field : animation.fields) {
    place.require(!field.name.empty() && !field.unit.empty(), "a field without name or unit");
    place.require(std::isfinite(field.low) && std::isfinite(field.high) && field.high > field.low,
                  "field \"" + field.name + "\" has no range");
    place.require(field.values.size() == animation.frames.size(),
                  "field \"" + field.name + "\" has not one row per frame");
    for (const auto& row : field.values) {
      place.require(row.size() == animation.cells.size(),
                    "field \"" + field.name + "\" has not one value per cell");
      for (const float value : row) place.require(std::isfinite(value), "a value is not finite");
    }
  }
}

void check_contact(const Place& place, const Animation& animation) {
  const AnimationContact& contact = animation.contact;
  if (contact.vertices.empty()) return;
  place.require(!contact.unit.empty(), "contact pressure without a unit");
  place.require(contact.pressure.size() == animation.frames.size(),
                "contact pressure has not one row per frame");
  for (const int vertex : contact.vertices)
    place.require(
        vertex >= 0 && static_cast<std::size_t>(vertex) < animation.frames.front().radius.size(),
        "the contact names a vertex that is not there");
  for (const auto& row : contact.pressure) {
    place.require(row.size() == contact.vertices.size(), "a row of contact pressure is ragged");
    check_numbers(place, row, "contact pressure");
  }
}

void check_animation(const Place& outside, const Animation& animation) {
  const Place place = outside.inside("animation", animation.title);
  place.require(!animation.title.empty(), "no title");
  place.require(!animation.length_unit.empty() && !animation.time_unit.empty(), "no unit");
  place.require(!animation.cells.empty() && !animation.frames.empty(), "no cells or no frames");
  const std::size_t vertices = animation.frames.front().radius.size();
  for (std::size_t i = 0; i < animation.frames.size(); ++i) {
    const AnimationFrame& frame = animation.frames[i];
    place.require(frame.radius.size() == vertices && frame.height.size() == vertices,
                  "a frame has not all vertices");
    check_numbers(place, frame.radius, "radius");
    check_numbers(place, frame.height, "height");
    place.require(std::isfinite(frame.time), "a time is not finite");
    place.require(i == 0 || frame.time > animation.frames[i - 1].time, "time does not increase");
  }
  for (const auto& cell : animation.cells) {
    for (const int vertex : cell) {
      place.require(vertex >= 0 && static_cast<std::size_t>(vertex) < vertices,
                    "a cell names a vertex that is not there");
    }
  }
  check_fields(place, animation);
  check_contact(place, animation);
}

/// A link leads to a page that was written with this one: never up, never to another server.
bool is_page_beside(const std::string& link) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./";
  return link.empty() || (link.front() != '/' && link.ends_with(".html") &&
                          link.find_first_not_of(plain) == std::string::npos &&
                          link.find("..") == std::string::npos);
}

void check_table(const Place& outside, const Table& table) {
  const Place place = outside.inside("table", table.title);
  place.require(!table.title.empty(), "no title");
  place.require(!table.columns.empty(), "no columns");
  for (const TableColumn& column : table.columns) {
    place.require(column.kind == TableColumn::Kind::text || !column.unit.empty(),
                  "column \"" + column.name + "\" has numbers without a unit");
  }
  for (const auto& row : table.rows) {
    place.require(row.size() == table.columns.size(), "a row has not one cell per column");
    for (const TableCell& cell : row)
      place.require(is_page_beside(cell.link), "\"" + cell.link + "\" is no page beside this one");
  }
}

using OverlayKeys = std::map<std::string, std::set<std::string>>;

void check_matrix(const Place& outside, const Matrix& matrix, const OverlayKeys& overlays) {
  const Place place = outside.inside("matrix", matrix.title);
  place.require(!matrix.title.empty(), "no title");
  place.require(!matrix.quantity.empty() && !matrix.unit.empty(), "no quantity or no unit");
  place.require(matrix.scale.limit > 0.0 && std::isfinite(matrix.scale.limit),
                "the colour scale has no positive limit");
  place.require(!matrix.columns.empty() && !matrix.rows.empty(), "no cells");
  const auto linked = overlays.find(matrix.overlays);
  place.require(matrix.overlays.empty() || linked != overlays.end(),
                "there are no overlays \"" + matrix.overlays + "\"");
  for (const MatrixRow& row : matrix.rows) {
    const Place at = place.inside("row", row.name);
    at.require(row.cells.size() == matrix.columns.size(), "not one cell per column");
    for (const MatrixCell& cell : row.cells) {
      at.require(!cell.text.empty(), "a cell shows neither a number nor why there is none");
      at.require(!cell.value || std::isfinite(*cell.value), "a value is not finite");
      at.require(!cell.hatched || !matrix.hatching.empty(), "hatching has no meaning given");
      at.require(cell.overlay.empty() ||
                     (linked != overlays.end() && linked->second.contains(cell.overlay)),
                 "there is no overlay \"" + cell.overlay + "\"");
    }
  }
}

void check_overlays(const Place& outside, const Overlays& overlays) {
  const Place place = outside.inside("overlays", overlays.id);
  place.require(!overlays.items.empty(), "empty");
  bool chosen_exists = false;
  for (const Overlay& overlay : overlays.items) {
    const Place at = place.inside("overlay", overlay.key);
    at.require(!overlay.key.empty() && !overlay.title.empty(), "no key or no title");
    chosen_exists = chosen_exists || overlay.key == overlays.chosen;
    for (const Figure& figure : overlay.figures) check_figure(at, figure);
    for (const Table& table : overlay.tables) check_table(at, table);
  }
  place.require(chosen_exists,
                "the overlay shown first, \"" + overlays.chosen + "\", is not there");
}

/// All blocks of a report with the place they stand in, in the order of reading.
std::vector<std::pair<Place, const Block*>> placed_blocks(const Place& place,
                                                          const Report& report) {
  std::vector<std::pair<Place, const Block*>> placed;
  for (const Block& block : report.lead) placed.emplace_back(place, &block);
  for (const Section& section : report.sections) {
    const Place at = place.inside("section", section.title);
    for (const Block& block : section.blocks) placed.emplace_back(at, &block);
    for (const Block& block : section.details) placed.emplace_back(at, &block);
  }
  return placed;
}

OverlayKeys overlay_keys(const Place& place, const Report& report) {
  OverlayKeys keys;
  for (const auto& [at, block] : placed_blocks(place, report)) {
    const auto* overlays = std::get_if<Overlays>(block);
    if (overlays == nullptr) continue;
    place.require(!overlays->id.empty() && !keys.contains(overlays->id),
                  "overlays id \"" + overlays->id + "\" is empty or used twice");
    for (const Overlay& overlay : overlays->items)
      place.require(keys[overlays->id].insert(overlay.key).second,
                    "overlay key \"" + overlay.key + "\" is used twice");
  }
  return keys;
}

}  // namespace

void check_report(const Report& report) {
  const Place place{"report \"" + report.title + "\""};
  place.require(!report.title.empty(), "no title");
  place.require(!report.headline.empty(), "no headline sentence");
  const OverlayKeys overlays = overlay_keys(place, report);
  for (const Section& section : report.sections)
    place.inside("section", section.title).require(!section.title.empty(), "no title");
  for (const auto& [at, block] : placed_blocks(place, report)) {
    if (const auto* table = std::get_if<Table>(block)) check_table(at, *table);
    if (const auto* figure = std::get_if<Figure>(block)) check_figure(at, *figure);
    if (const auto* moving = std::get_if<Animation>(block)) check_animation(at, *moving);
    if (const auto* matrix = std::get_if<Matrix>(block)) check_matrix(at, *matrix, overlays);
    if (const auto* items = std::get_if<Overlays>(block)) check_overlays(at, *items);
  }
}

}  // namespace rebound::report
