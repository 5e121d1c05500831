#include <fmt/format.h>

#include <algorithm>

#include "comparisons/studies/study/study_report.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

using report::milli;
using report::Origin;
using report::scaled;
using report::Series;

constexpr int drawn_points = 101;  // a pixel or two apart in the widest figure

Series series_of(const std::string& name, Origin origin, Series::Role role) {
  return {.name = name, .origin = origin, .role = role};
}

/// The FE trace up to the end of contact, with the two meshes as its band.
struct FemCurve {
  Trace trace;
  std::vector<double> force_low, force_high;
};

FemCurve fem_curve(const StudyShot& shot) {
  FemCurve curve;
  const Trace& fine = shot.fem.trace;
  const Trace& coarse = shot.fem_coarse.trace;
  const auto end = static_cast<std::size_t>(
      std::upper_bound(fine.time.begin(), fine.time.end(), shot.fem.scalars.contact_time) -
      fine.time.begin());
  const std::size_t stride = std::max<std::size_t>(1, end / drawn_points);
  // Every few samples, and the last.
  for (std::size_t i = 0; i < end; i = i + 1 < end ? std::min(i + stride, end - 1) : end) {
    curve.trace.time.push_back(fine.time[i]);
    curve.trace.force.push_back(fine.force[i]);
    curve.trace.deflection.push_back(fine.deflection[i]);
    // Same output grid on both meshes: the interval depends on the problem alone.
    const double other = i < coarse.force.size() ? coarse.force[i] : 0.0;
    curve.force_low.push_back(std::min(fine.force[i], other));
    curve.force_high.push_back(std::max(fine.force[i], other));
  }
  return curve;
}

/// The three views of one impact: what is added goes into each.
struct Views {
  report::Figure loop{.title = "Force against deflection",
                      .caption =
                          "Deflection of the centre of mass. Points: peaks that the paper "
                          "calls typical of its four cores together.",
                      .x = {"deflection", "mm"},
                      .y = {"force", "N"}};
  report::Figure history{.title = "Force against time",
                         .caption = "Band: FE on the coarse and on the reference mesh.",
                         .x = {"time", "ms"},
                         .y = {"force", "N"}};
  report::Figure motion{.title = "Deflection against time",
                        .caption = "Point on the axis: measured contact time.",
                        .x = {"time", "ms"},
                        .y = {"deflection", "mm"}};

  void add(const std::string& name, Origin origin, Series::Role role, const Trace& trace) {
    Series series = series_of(name, origin, role);
    series.x = scaled(trace.deflection, milli);
    series.y = trace.force;
    loop.series.push_back(series);
    series.x = scaled(trace.time, milli);
    history.series.push_back(series);
    series.y = scaled(trace.deflection, milli);
    motion.series.push_back(series);
  }
};

void add_models(const CoreStudy& core, std::size_t s, Views& views) {
  // Restitution and contact time were fitted; no trace was.
  const FemCurve fem = fem_curve(core.shots[s]);
  views.add("FE", Origin::predicted, Series::Role::reference, fem.trace);
  views.history.series.back().y_low = fem.force_low;
  views.history.series.back().y_high = fem.force_high;
  for (std::size_t l = 0; l < core.laws.size(); ++l) {
    if (!core.benchmark.cells[l][s].failure.empty()) continue;
    const LumpedResult law = simulate({.sphere = core.data.sphere,
                                       .impact = core.shots[s].problem.impact,
                                       .model = core.laws[l].model,
                                       .controls = {.samples = drawn_points}});
    const Origin origin = core.laws[l].fit ? Origin::fitted : Origin::predicted;
    views.add(core.laws[l].label, origin, Series::Role::candidate, law.trace);
  }
}

void add_measured(const CoreStudy& core, const StudyShot& shot, Views& views) {
  const auto point = [](const std::string& name, double x, double y) {
    Series series = series_of(name, Origin::measured, Series::Role::reference);
    series.style = Series::Style::points;
    series.x = {x};
    series.y = {y};
    return series;
  };
  for (const auto& peak : core.data.pooled_peaks)
    if (peak.speed == shot.measured.impact.speed)
      views.loop.series.push_back(
          point("typical peaks, four cores", milli * peak.deflection, peak.force));
  const Measured& time = shot.measured.contact_time;
  if (!time.value) return;
  views.motion.series.push_back(point("contact time", milli * *time.value, 0.0));
  views.motion.series.back().x_error = {milli * time.uncertainty.value_or(0)};
}

report::Overlay overlay_of(const CoreStudy& core, std::size_t s) {
  const StudyShot& shot = core.shots[s];
  Views views;
  add_models(core, s, views);
  add_measured(core, shot, views);
  return {.key = overlay_key(core, shot),
          .title = fmt::format("Core {} at {:g} m/s", core.label, shot.measured.impact.speed),
          .note =
              "The measurement published no traces: only scalars are drawn "
              "as measured.",
          .figures = {views.loop, views.history, views.motion},
          .tables = {}};
}

report::Table scalar_table(const CoreStudy& core, std::size_t s) {
  using ColumnKind = report::TableColumn::Kind;
  const StudyShot& shot = core.shots[s];
  report::Table table{.title = "Scalars side by side",
                      .caption =
                          "FE ± distance between its two meshes. Contact time by "
                          "zero force; FE also above the instrument's threshold.",
                      .columns = {{"by", "", ColumnKind::text, {}},
                                  {"restitution", "1", ColumnKind::number, {}},
                                  {"contact time", "ms", ColumnKind::number, {}},
                                  {"peak force", "N", ColumnKind::number, {}},
                                  {"peak deflection", "mm", ColumnKind::number, {}},
                                  {"mean deflection", "mm", ColumnKind::number, {}}},
                      .rows = {}};
  const auto measured = [](const Measured& value, double factor) {
    if (!value.value) return report::text_cell("–");
    report::TableCell cell = value.uncertainty ? report::uncertain_cell(factor * *value.value,
                                                                        factor * *value.uncertainty)
                                               : report::number_cell(factor * *value.value, 3);
    cell.origin = Origin::measured;
    return cell;
  };
  table.rows.push_back({report::text_cell("measured"), measured(shot.measured.restitution, 1),
                        measured(shot.measured.contact_time, milli),
                        measured(shot.measured.peak_force, 1),
                        measured(shot.measured.peak_deflection, milli),
                        measured(shot.measured.mean_deflection, milli)});
  const auto fem = [&](double ImpactScalars::*scalar, double factor) {
    const double bar = factor * spread(shot, scalar);
    const double value = factor * shot.fem.scalars.*scalar;
    return bar > 0 ? report::uncertain_cell(value, bar) : report::number_cell(value, 4);
  };
  table.rows.push_back(
      {report::text_cell("FE"), fem(&ImpactScalars::restitution, 1),
       fem(&ImpactScalars::contact_time, milli), fem(&ImpactScalars::peak_force, 1),
       fem(&ImpactScalars::peak_deflection, milli), fem(&ImpactScalars::mean_deflection, milli)});
  for (std::size_t l = 0; l < core.laws.size(); ++l) {
    const LawScore& cell = core.benchmark.cells[l][s];
    if (!cell.failure.empty()) {
      table.rows.push_back({report::text_cell(core.laws[l].label), report::text_cell(cell.failure),
                            report::text_cell("–"), report::text_cell("–"), report::text_cell("–"),
                            report::text_cell("–")});
      continue;
    }
    table.rows.push_back({report::text_cell(core.laws[l].label),
                          report::number_cell(cell.scalars.restitution, 3),
                          report::number_cell(milli * cell.scalars.contact_time, 3),
                          report::number_cell(cell.scalars.peak_force, 3),
                          report::number_cell(milli * cell.scalars.peak_deflection, 3),
                          report::number_cell(milli * cell.scalars.mean_deflection, 3)});
  }
  return table;
}

}  // namespace

report::Section overlay_section(const std::vector<CoreStudy>& cores) {
  report::Section section{.title = "What does one impact look like?", .blocks = {}};
  report::Overlays overlays{.id = "impacts", .chosen = {}, .items = {}};
  for (const auto& core : cores)
    for (std::size_t s = 0; s < core.shots.size(); ++s) {
      overlays.items.push_back(overlay_of(core, s));
      overlays.items.back().tables.push_back(scalar_table(core, s));
    }
  overlays.chosen = overlays.items.front().key;
  section.blocks.push_back(std::move(overlays));
  return section;
}

}  // namespace rebound
