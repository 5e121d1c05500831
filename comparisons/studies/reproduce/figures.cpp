#include "comparisons/studies/reproduce/figures.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rebound {
namespace {

using report::milli;
using report::scaled;

constexpr const char* overlays_id = "published-impacts";
constexpr const char* label = "Predicted from published parameters; the paper prints no trace.";

const report::Axis deflection_axis{"deflection of the centre of mass", "mm"};
const report::Axis force_axis{"force", "N"};
const report::Axis time_axis{"time", "ms"};

report::Series line(const std::string& name, const std::vector<double>& x,
                    const std::vector<double>& y) {
  report::Series series;
  series.name = name;
  series.origin = report::Origin::predicted;
  series.x = x;
  series.y = y;
  return series;
}

/// Every fourth point and the last: still closer than two pixels.
std::vector<double> drawn(const std::vector<double>& values) {
  constexpr std::size_t stride = 4;
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  if (values.size() % stride != 1) kept.push_back(values.back());
  return kept;
}

report::Series force_over_deflection(const std::string& name, const Trace& trace) {
  return line(name, scaled(drawn(trace.deflection), milli), drawn(trace.force));
}

report::Series deflection_over_time(const std::string& name, const Trace& trace) {
  return line(name, scaled(drawn(trace.time), milli), scaled(drawn(trace.deflection), milli));
}

std::string key_of(const PaperCore& core, const PaperShot& shot) {
  return fmt::format("{}/{:g}", core.name, shot.speed);
}

/// Measured scalars beside the model's, with half a digit of rounding.
report::Table scalar_table(const PaperCore&, const PaperShot& shot, const ModelRun& run) {
  const ImpactScalars& model = run.result.scalars;
  report::Table table;
  table.title = "Scalars";
  table.caption = "Measured: as printed, with half a unit of the last digit.";
  table.columns = {
      {"quantity"},
      {"measured", "as named", report::TableColumn::Kind::number, report::Origin::measured},
      {"published Hunt-Crossley", "as named", report::TableColumn::Kind::number,
       report::Origin::predicted}};
  const auto add = [&](const char* name, const PrintedNumber& measured, double predicted,
                       double scale) {
    table.rows.push_back(
        {report::text_cell(name),
         report::uncertain_cell(scale * measured.value, scale * measured.half_width),
         report::number_cell(scale * predicted, 4)});
  };
  add("restitution", shot.restitution, model.restitution, 1.0);
  add("contact time, ms", shot.contact_time, model.contact_time, milli);
  add("mean deflection, mm", shot.mean_deflection, model.mean_deflection, milli);
  return table;
}

report::Overlay impact_overlay(const PaperCore& core, const PaperShot& shot, const ModelRun& run) {
  const std::string name = "Hunt-Crossley, published parameters";
  report::Overlay overlay;
  overlay.key = key_of(core, shot);
  overlay.title = fmt::format("Core {} at {:g} m/s", core.name, shot.speed);
  overlay.note = label;
  overlay.figures = {{"Fig. 3: force over deflection",
                      label,
                      deflection_axis,
                      force_axis,
                      {force_over_deflection(name, run.result.trace)}},
                     {"Fig. 4: deflection over time",
                      label,
                      time_axis,
                      deflection_axis,
                      {deflection_over_time(name, run.result.trace)}}};
  overlay.tables = {scalar_table(core, shot, run)};
  return overlay;
}

double per_cent_above(const ModelRun& run, const PaperShot& shot) {
  return 100.0 * (run.result.scalars.contact_time / shot.contact_time.value - 1.0);
}

}  // namespace

report::Overlays published_impacts(const Reproduction& reproduction) {
  report::Overlays overlays{.id = overlays_id, .chosen = {}, .items = {}};
  for (std::size_t i = 0; i < reproduction.paper.cores.size(); ++i) {
    const PaperCore& core = reproduction.paper.cores[i];
    for (std::size_t j = 0; j < core.shots.size(); ++j)
      overlays.items.push_back(impact_overlay(core, core.shots[j], reproduction.runs[i][j]));
  }
  overlays.chosen = overlays.items[1].key;
  return overlays;
}

report::Matrix contact_time_matrix(const Reproduction& reproduction) {
  report::Matrix matrix;
  matrix.title = "Published Hunt-Crossley model: contact time against the measured one";
  matrix.caption =
      "A cell leads to Figs 3 and 4 of that impact. Hatched: beyond the largest "
      "difference the text allows.";
  matrix.quantity = "difference of contact time";
  matrix.unit = "%";
  matrix.row_heading = "core";
  matrix.hatching = "beyond the largest difference the text allows";
  matrix.scale = {report::ColourScale::Kind::diverging, 20.0};
  matrix.overlays = overlays_id;
  double allowed = INFINITY;
  for (const Claim& claim : reproduction.paper.claims)
    if (claim.id == "nonlinear-contact-time-largest-difference")
      allowed = claim.value.value + claim.value.half_width;
  for (const PaperShot& shot : reproduction.paper.cores.front().shots)
    matrix.columns.push_back({"speed", fmt::format("{:g} m/s", shot.speed)});
  for (std::size_t i = 0; i < reproduction.paper.cores.size(); ++i) {
    const PaperCore& core = reproduction.paper.cores[i];
    report::MatrixRow row{.name = core.name, .cells = {}};
    for (std::size_t j = 0; j < core.shots.size(); ++j) {
      const double difference = per_cent_above(reproduction.runs[i][j], core.shots[j]);
      row.cells.push_back({.value = difference,
                           .text = fmt::format("{:+.1f}", difference),
                           .hatched = std::abs(difference) > allowed,
                           .overlay = key_of(core, core.shots[j]),
                           .highlight = ""});
    }
    matrix.rows.push_back(row);
  }
  return matrix;
}

report::Figure figure_5(const Reproduction& reproduction) {
  report::Figure figure{.title = "Fig. 5: contact time over speed",
                        .caption =
                            "Measured: Table 5, bars are half a printed digit. Predicted "
                            "from published parameters: bars are what rounding allows.",
                        .x = {"nominal speed", "m/s"},
                        .y = {"contact time", "ms"}};
  for (std::size_t i = 0; i < reproduction.paper.cores.size(); ++i) {
    const PaperCore& core = reproduction.paper.cores[i];
    report::Series measured, model;
    measured.name = fmt::format("core {}, measured", core.name);
    measured.origin = report::Origin::measured;
    measured.style = model.style = report::Series::Style::points;
    model.name = fmt::format("core {}, published Hunt-Crossley", core.name);
    for (std::size_t j = 0; j < core.shots.size(); ++j) {
      const PaperShot& shot = core.shots[j];
      const ModelRun& run = reproduction.runs[i][j];
      measured.x.push_back(shot.speed);
      measured.y.push_back(milli * shot.contact_time.value);
      measured.y_error.push_back(milli * shot.contact_time.half_width);
      model.x.push_back(shot.speed);
      model.y.push_back(milli * run.result.scalars.contact_time);
      model.y_error.push_back(milli * 0.5 * (run.contact_time.high - run.contact_time.low));
    }
    figure.series.push_back(measured);
    figure.series.push_back(model);
  }
  return figure;
}

std::vector<report::Figure> figure_6(const Reproduction& reproduction) {
  report::Figure force{.title = "Fig. 6(a): force over deflection, stiffness varied",
                       .caption = label,
                       .x = deflection_axis,
                       .y = force_axis};
  report::Figure motion{.title = "Fig. 6(b): deflection over time, stiffness varied",
                        .caption = label,
                        .x = time_axis,
                        .y = deflection_axis};
  for (const StudyRun& run : run_parameter_study(reproduction.paper.parameter_study)) {
    const std::string name = fmt::format("{:g}e6 N/m^1.5", 1e-6 * run.stiffness);
    force.series.push_back(force_over_deflection(name, run.result.trace));
    motion.series.push_back(deflection_over_time(name, run.result.trace));
  }
  return {force, motion};
}

}  // namespace rebound
