#include "comparisons/io/report/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "comparisons/io/report/packed_values.hpp"

namespace rebound::report {

using nlohmann::json;

// Found by argument-dependent lookup from nlohmann's containers, so these stand in
// the records' own namespace.

NLOHMANN_JSON_SERIALIZE_ENUM(Origin, {{Origin::measured, "measured"},
                                      {Origin::derived, "derived"},
                                      {Origin::fitted, "fitted"},
                                      {Origin::predicted, "predicted"}})

// A macro argument cannot hold the qualified names of nested enums twice over.
using Level = Notice::Level;
NLOHMANN_JSON_SERIALIZE_ENUM(Level, {{Level::finding, "finding"},
                                     {Level::abstention, "abstention"},
                                     {Level::warning, "warning"},
                                     {Level::failure, "failure"}})

using Verdict = TableCell::Verdict;
NLOHMANN_JSON_SERIALIZE_ENUM(Verdict, {{Verdict::none, "none"},
                                       {Verdict::good, "good"},
                                       {Verdict::doubtful, "doubtful"},
                                       {Verdict::bad, "bad"}})

namespace {

template <class Value>
json optional_json(const std::optional<Value>& value) {
  return value ? json(*value) : json(nullptr);
}

/// Five digits are ten times finer than a pixel and a third of the size of all of them.
/// The full numbers stand in the result files.
std::vector<double> drawn(const std::vector<double>& values) {
  std::vector<double> shown;
  shown.reserve(values.size());
  for (const double value : values) {
    const double rounded = std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr);
    shown.push_back(std::isfinite(rounded) ? rounded : value);
  }
  return shown;
}

}  // namespace

static void to_json(json& out, const Axis& axis) {
  out = {{"quantity", axis.quantity},
         {"unit", axis.unit},
         {"logarithmic", axis.spacing == Axis::Spacing::logarithmic}};
}

static void to_json(json& out, const Series& series) {
  out = {{"name", series.name},
         {"origin", series.origin},
         {"style", series.style == Series::Style::line ? "line" : "points"},
         {"reference", series.role == Series::Role::reference},
         {"x", drawn(series.x)},
         {"y", drawn(series.y)},
         {"x_error", drawn(series.x_error)},
         {"y_error", drawn(series.y_error)},
         {"y_low", drawn(series.y_low)},
         {"y_high", drawn(series.y_high)}};
}

static void to_json(json& out, const Figure& figure) {
  out = {{"kind", "figure"}, {"title", figure.title}, {"caption", figure.caption},
         {"x", figure.x},    {"y", figure.y},         {"series", figure.series}};
}

static void to_json(json& out, const AnimationFrame& frame) {
  out = {{"time", frame.time}, {"radius", frame.radius}, {"height", frame.height}};
}

static void to_json(json& out, const AnimationField& field) {
  out = {{"name", field.name},
         {"unit", field.unit},
         {"low", field.low},
         {"high", field.high},
         {"values", packed_values(field.values, {.low = field.low, .high = field.high})}};
}

static void to_json(json& out, const AnimationContact& contact) {
  out = {{"unit", contact.unit}, {"vertices", contact.vertices}, {"pressure", contact.pressure}};
}

static void to_json(json& out, const Animation& animation) {
  out = {{"kind", "animation"},
         {"title", animation.title},
         {"caption", animation.caption},
         {"origin", animation.origin},
         {"length_unit", animation.length_unit},
         {"time_unit", animation.time_unit},
         {"cells", animation.cells},
         {"frames", animation.frames},
         {"fields", animation.fields},
         {"contact", animation.contact}};
}

static void to_json(json& out, const TableColumn& column) {
  out = {{"name", column.name},
         {"unit", column.unit},
         {"number", column.kind == TableColumn::Kind::number},
         {"origin", optional_json(column.origin)}};
}

static void to_json(json& out, const TableCell& cell) {
  out = {{"text", cell.text}, {"verdict", cell.verdict}, {"origin", optional_json(cell.origin)}};
  if (!cell.link.empty()) out["link"] = cell.link;
}

static void to_json(json& out, const Table& table) {
  out = {{"kind", "table"},
         {"title", table.title},
         {"caption", table.caption},
         {"columns", table.columns},
         {"rows", table.rows}};
}

static void to_json(json& out, const MatrixCell& cell) {
  out = {{"value", optional_json(cell.value)},
         {"text", cell.text},
         {"hatched", cell.hatched},
         {"overlay", cell.overlay},
         {"highlight", cell.highlight}};
}

static void to_json(json& out, const MatrixColumn& column) {
  out = {{"group", column.group}, {"name", column.name}};
}

static void to_json(json& out, const MatrixRow& row) {
  out = {{"name", row.name}, {"cells", row.cells}};
}

static void to_json(json& out, const Matrix& matrix) {
  out = {{"kind", "matrix"},
         {"title", matrix.title},
         {"caption", matrix.caption},
         {"quantity", matrix.quantity},
         {"unit", matrix.unit},
         {"row_heading", matrix.row_heading},
         {"hatching", matrix.hatching},
         {"diverging", matrix.scale.kind == ColourScale::Kind::diverging},
         {"limit", matrix.scale.limit},
         {"overlays", matrix.overlays},
         {"columns", matrix.columns},
         {"rows", matrix.rows}};
}

static void to_json(json& out, const Paragraph& paragraph) {
  out = {{"kind", "paragraph"}, {"text", paragraph.text}};
}

static void to_json(json& out, const Notice& notice) {
  out = {{"kind", "notice"},
         {"level", notice.level},
         {"text", notice.text},
         {"evidence", notice.evidence}};
}

static void to_json(json& out, const Verbatim& verbatim) {
  out = {{"kind", "verbatim"}, {"title", verbatim.title}, {"text", verbatim.text}};
}

static void to_json(json& out, const Overlay& overlay) {
  out = {{"key", overlay.key},
         {"title", overlay.title},
         {"note", overlay.note},
         {"figures", overlay.figures},
         {"tables", overlay.tables}};
}

static void to_json(json& out, const Overlays& overlays) {
  out = {{"kind", "overlays"},
         {"id", overlays.id},
         {"chosen", overlays.chosen},
         {"items", overlays.items}};
}

static json blocks_json(const std::vector<Block>& blocks) {
  json list = json::array();
  for (const Block& block : blocks)
    list.push_back(std::visit([](const auto& each) { return json(each); }, block));
  return list;
}

static void to_json(json& out, const Section& section) {
  out = {{"title", section.title},
         {"folded", section.folding == Section::Folding::folded},
         {"blocks", blocks_json(section.blocks)},
         {"details", blocks_json(section.details)}};
}

json report_json(const Report& report) {
  return {{"schema", 1},
          {"title", report.title},
          {"subtitle", report.subtitle},
          {"question", report.question},
          {"headline", report.headline},
          {"lead", blocks_json(report.lead)},
          {"notices", report.notices},
          {"sections", report.sections}};
}

}  // namespace rebound::report
