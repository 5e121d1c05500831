#include "comparisons/diagnosis/diagnosis_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparisons/config/describe_effect.hpp"
#include "comparisons/diagnosis/diagnosis_json.hpp"

namespace rebound {
namespace {

using report::number_cell;
using report::Origin;
using report::Series;
using report::text_cell;
using Kind = report::TableColumn::Kind;

constexpr double milli = 1e3;

report::Notice::Level level_of(DiagnosisVerdict verdict) {
  using Level = report::Notice::Level;
  switch (verdict) {
    case DiagnosisVerdict::agrees:
    case DiagnosisVerdict::missing: return Level::finding;
    case DiagnosisVerdict::one_of:
    case DiagnosisVerdict::unexplained:
    case DiagnosisVerdict::insufficient_data: return Level::abstention;
    case DiagnosisVerdict::measurement_fault: return Level::failure;
  }
  return Level::warning;
}

std::string gap_sentence(const Diagnosis& d) {
  if (!d.gap.before) return "No gap was computed.";
  const auto step = [](const std::optional<double>& before, const std::optional<double>& after) {
    return after ? fmt::format("{:.3g} to {:.3g}", *before, *after) : fmt::format("{:.3g}", *before);
  };
  std::string text = fmt::format("Gap {} (reduced whitened χ², the noise is 1)",
                                 step(d.gap.before, d.gap.after));
  if (d.held_out_speed && d.gap.held_out_before)
    text += fmt::format("; at {:g} m/s, which no fit saw, {}", *d.held_out_speed,
                        step(d.gap.held_out_before, d.gap.held_out_after));
  return text + fmt::format(". Noise from: {}.", d.seen->noise_from);
}

/// Speed × phase: mean whitened residual of the baseline.
report::Matrix map_matrix(const Diagnosis& d) {
  const ResidualMap& map = d.believed.map;
  report::Matrix matrix{.title = "Where model and data disagree",
                        .caption = fmt::format(
                            "Mean residual of the believed model, refitted, over its spread when "
                            "nothing is missing: beyond ±{:.1f} the noise alone goes once in fifty "
                            "maps. Positive: the model is too high.", map.threshold),
                        .quantity = "mean whitened residual z",
                        .unit = "1",
                        .row_heading = "shot",
                        .hatching = "within the noise",
                        .scale = {report::ColourScale::Kind::diverging, std::max(10.0, map.threshold)},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  std::vector<std::pair<Phase, ObservedQuantity>> columns;
  for (const MapCell& cell : map.cells) {
    const std::pair key{cell.phase, cell.what};
    if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
  }
  std::sort(columns.begin(), columns.end());
  for (const auto& [phase, what] : columns) matrix.columns.push_back({name_of(what), name_of(phase)});
  for (std::size_t i = 0; i < d.seen->shots.size(); ++i) {
    report::MatrixRow row{d.seen->shots[i].label, {}};
    for (const auto& [phase, what] : columns) {
      report::MatrixCell cell{.value = {}, .text = "–"};
      for (const MapCell& c : map.cells)
        if (c.shot == i && c.phase == phase && c.what == what)
          cell = {.value = c.z, .text = fmt::format("{:+.1f}", c.z),
                  .hatched = std::abs(c.z) <= map.threshold};
      row.cells.push_back(cell);
    }
    matrix.rows.push_back(row);
  }
  return matrix;
}

Series line(const std::string& name, Origin origin, const std::vector<double>& time,
            const std::vector<double>& force) {
  Series series{.name = name, .origin = origin, .role = Series::Role::candidate, .x = {}, .y = force,
                .x_error = {}, .y_error = {}, .y_low = {}, .y_high = {}};
  for (const double t : time) series.x.push_back(milli * t);
  return series;
}

/// The measured history: points with their noise, thinned so that lines stay visible.
Series measured_points(const ForceHistory& history) {
  Series series{.name = "measured", .origin = Origin::measured, .style = Series::Style::points,
                .role = Series::Role::reference, .x = {}, .y = {}, .x_error = {}, .y_error = {},
                .y_low = {}, .y_high = {}};
  constexpr std::size_t shown = 120;
  const std::size_t stride = std::max<std::size_t>(1, history.time.size() / shown);
  for (std::size_t i = 0; i < history.time.size(); i += stride) {
    series.x.push_back(milli * history.time[i]);
    series.y.push_back(history.force[i]);
    series.y_error.push_back(history.noise);
  }
  return series;
}

report::Figure history_figure(const ObservedShot& shot, const std::string& title,
                              const std::string& caption, const std::vector<double>& before,
                              const std::vector<double>* after, Origin origin) {
  const ForceHistory& history = *shot.history;
  report::Figure figure{.title = title, .caption = caption, .x = {"time", "ms"}, .y = {"force", "N"},
                        .series = {}};
  figure.series.push_back(measured_points(history));
  figure.series.push_back(line("believed model, refitted", origin, history.time, before));
  if (after) figure.series.push_back(line("with the effect", origin, history.time, *after));
  return figure;
}

void add_pictures(const Diagnosis& d, report::Section& section) {
  const HypothesisFit& before = d.believed.fit;
  const HypothesisFit* after = d.gap.after ? &d.best() : nullptr;
  for (std::size_t i = 0; i < d.unseen->shots.size(); ++i) {
    const ObservedShot& shot = d.unseen->shots[i];
    if (!shot.history || !d.unseen_before) continue;
    section.blocks.push_back(history_figure(
        shot, "Held out: " + shot.label,
        "No fit saw this shot. Points with one standard deviation of the noise.",
        d.unseen_before->force[i], d.unseen_after ? &d.unseen_after->force[i] : nullptr,
        Origin::predicted));
  }
  for (std::size_t i = 0; i < d.seen->shots.size(); ++i) {
    const ObservedShot& shot = d.seen->shots[i];
    if (!shot.history) continue;
    const auto with = after ? after->model->force_at(after->values, i, shot.history->time)
                            : std::vector<double>{};
    section.blocks.push_back(history_figure(
        shot, "Fitted: " + shot.label, "Points with one standard deviation of the noise.",
        before.model->force_at(before.values, i, shot.history->time), after ? &with : nullptr,
        Origin::fitted));
  }
}

std::string sizes_of(const HypothesisFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const auto& unknowns = fit.model->unknowns_of_effect(k);
    if (!text.empty()) text += "; ";
    if (unknowns.empty()) {
      text += "on";
      continue;
    }
    const Estimate& e = fit.search.estimates[unknowns[0]];
    text += std::isfinite(e.standard_error) ? fmt::format("{:.3g} ± {:.2g}", e.value, e.standard_error)
                                            : fmt::format("{:.3g}, not identifiable", e.value);
  }
  return text;
}

report::Table candidate_table(const Diagnosis& d) {
  report::Table table{.title = "Effects that were tried",
                      .caption = "Size in SI with one standard error. ΔBIC: over the best of all; "
                                 "left: largest further Δχ² of any other effect, to be below the "
                                 "limit beside it.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "SI", Kind::text, Origin::fitted},
                                  {"χ² / dof", "1", Kind::number, {}},
                                  {"ΔBIC", "1", Kind::number, {}},
                                  {"left", "1", Kind::number, {}},
                                  {"limit", "1", Kind::number, {}},
                                  {"explains the data", "", Kind::text, {}}},
                      .rows = {}};
  const auto& tried = d.selection.tried;
  for (const JudgedFit& c : tried)
    table.rows.push_back(
        {text_cell(label_of(c.fit.effects)), text_cell(sizes_of(c.fit)),
         number_cell(c.fit.reduced_chi_square(), 3),
         text_cell(fmt::format("{:.1f}", c.fit.information_criterion -
                                             tried.front().fit.information_criterion)),
         number_cell(c.best_remaining, 3), number_cell(c.remaining_threshold, 3),
         text_cell(c.adequate ? "yes" : "no", c.adequate ? report::TableCell::Verdict::good
                                                         : report::TableCell::Verdict::bad)});
  return table;
}

report::Table excluded_table(const Diagnosis& d) {
  report::Table table{.title = "Excluded above",
                      .caption = "The largest size of each effect that these data leave possible, "
                                 "at 95 %, one at a time.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "SI", Kind::number, Origin::derived},
                                  {"unit", "", Kind::text, {}}},
                      .rows = {}};
  for (const auto& e : d.excluded) {
    const std::string unit = size_unit(find_effect(e.name).card);
    table.rows.push_back({text_cell(e.name), number_cell(e.size, 2),
                          text_cell(unit.empty() ? "1" : unit)});
  }
  return table;
}

report::Table next_table(const Diagnosis& d) {
  report::Table table{.title = "Measure next",
                      .caption = "P: chance that the right candidate then leads by more than the "
                                 "close criterion; an upper bound.",
                      .columns = {{"experiment", "", Kind::text, {}},
                                  {"tells", "", Kind::text, {}},
                                  {"P", "1", Kind::number, Origin::predicted}},
                      .rows = {}};
  for (const auto& e : d.next)
    table.rows.push_back({text_cell(e.what), text_cell(e.separates[0] + " from " + e.separates[1]),
                          text_cell(fmt::format("{:.2f}", e.probability))});
  return table;
}

report::Matrix cosine_matrix(const Diagnosis& d) {
  const auto& cosines = d.selection.cosines;
  report::Matrix matrix{.title = "Which effects look alike in these data",
                        .caption = "Cosine between what two effects do to the residuals, what the "
                                   "fit can absorb taken out. ±1: cannot be told apart by any fit.",
                        .quantity = "cosine",
                        .unit = "1",
                        .row_heading = "effect",
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::diverging, 1.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  for (std::size_t i = 0; i < cosines.names.size(); ++i) {
    matrix.columns.push_back({"", cosines.names[i]});
    report::MatrixRow row{cosines.names[i], {}};
    for (std::size_t j = 0; j < cosines.names.size(); ++j) {
      const double value = cosines.cosine(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      row.cells.push_back({.value = value, .text = fmt::format("{:.2f}", value)});
    }
    matrix.rows.push_back(row);
  }
  return matrix;
}

}  // namespace

std::vector<report::Section> diagnosis_sections(const Diagnosis& d, const std::string& name) {
  report::Section section{.title = "Diagnosis: " + name, .folding = report::Section::Folding::open,
                          .blocks = {}};
  section.blocks.push_back(report::Notice{level_of(d.verdict), headline(d)});
  if (d.seen) section.blocks.push_back(report::Paragraph{gap_sentence(d)});
  for (const auto& needed : d.needed)
    section.blocks.push_back(report::Paragraph{"Needed: " + needed + "."});
  if (!d.next.empty()) section.blocks.push_back(next_table(d));
  report::Section details{.title = "Diagnosis in detail: " + name,
                          .folding = report::Section::Folding::folded, .blocks = {}};
  if (d.gap.before) {
    section.blocks.push_back(map_matrix(d));
    add_pictures(d, section);
    if (!d.selection.tried.empty()) section.blocks.push_back(candidate_table(d));
    if (!d.excluded.empty()) section.blocks.push_back(excluded_table(d));
    if (!d.selection.cosines.names.empty()) details.blocks.push_back(cosine_matrix(d));
  }
  for (const auto& warning : d.warnings)
    details.blocks.push_back(report::Notice{report::Notice::Level::warning, warning});
  if (details.blocks.empty()) return {section};
  return {section, details};
}

report::Report diagnosis_report(const Diagnosis& d, const std::string& name,
                                const Provenance& provenance) {
  report::Report page;
  page.title = "Diagnosis: " + name;
  page.subtitle = "A believed model against data: where they disagree, and what is missing";
  page.headline = headline(d);
  page.sections = diagnosis_sections(d, name);
  page.sections.push_back({.title = "Provenance", .folding = report::Section::Folding::folded,
                           .blocks = {report::Verbatim{"Run", dump(to_json(provenance))}}});
  return page;
}

}  // namespace rebound
