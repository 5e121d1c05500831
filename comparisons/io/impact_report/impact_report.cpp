#include "comparisons/io/impact_report/impact_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/report/half_section.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using report::Figure;
using report::milli;
using report::scaled;
using report::Series;

constexpr int most_frames = 60;
constexpr int most_cells = 20000;
constexpr int most_cell_frames = 150000;

Series line(const std::string& name, std::vector<double> x, std::vector<double> y) {
  Series series;
  series.name = name;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

const std::vector<double>* column(const Trace& trace, const std::string& name) {
  for (const TraceColumn& candidate : trace.further)
    if (candidate.name == name) return &candidate.values;
  return nullptr;
}

/// Force in newtons, with the band of a reference run.
Series force_over(const Trace& trace, std::vector<double> x) {
  Series series = line("force", std::move(x), trace.force);
  if (const auto* half_width = column(trace, "force_uncertainty_N"))
    for (std::size_t i = 0; i < trace.force.size(); ++i) {
      series.y_low.push_back(trace.force[i] - (*half_width)[i]);
      series.y_high.push_back(trace.force[i] + (*half_width)[i]);
    }
  return series;
}

Figure force_time(const Trace& trace) {
  Figure figure{.title = "Force over time",
                .caption =
                    "What the instrument reads: mean over each sample, so that the area under "
                    "the line is the impulse.",
                .x = {"time since first touch", "ms"},
                .y = {"force", "N"},
                .series = {force_over(trace, scaled(trace.time, milli))}};
  if (const auto* contact = column(trace, "contact_force_N"))
    figure.series.push_back(line("contact force", scaled(trace.time, milli), *contact));
  return figure;
}

Figure force_deflection(const Trace& trace) {
  Figure figure{.title = "Force over deflection",
                .caption =
                    "The area inside the loop of the centre of mass is the energy that does not "
                    "come back as its motion.",
                .x = {"deflection", "mm"},
                .y = {"force", "N"},
                .series = {line("centre of mass", scaled(trace.deflection, milli), trace.force)}};
  if (const auto* pole = column(trace, "pole_deflection_m"))
    figure.series.push_back(line("pole", scaled(*pole, milli), trace.force));
  return figure;
}

Figure energies(const FemResult& result) {
  struct Channel {
    const char* name;
    double EnergyBalance::*member;
  };
  constexpr Channel channels[] = {
      {"motion of the centre of mass", &EnergyBalance::kinetic_centre_of_mass},
      {"vibration", &EnergyBalance::kinetic_vibration},
      {"stored by the elastic law", &EnergyBalance::stored},
      {"held by branches", &EnergyBalance::held},
      {"dissipated in the ball", &EnergyBalance::dissipated},
      {"lost where nodes are caught", &EnergyBalance::contact_constraint},
      {"friction", &EnergyBalance::friction},
      {"adhesion", &EnergyBalance::adhesion},
      {"plate, kinetic", &EnergyBalance::plate_kinetic},
      {"plate, spring", &EnergyBalance::plate_spring},
      {"plate, damper", &EnergyBalance::plate_damper},
      {"weight", &EnergyBalance::gravity}};
  Figure figure{
      .title = "Where the energy is",
      .caption = "All channels; their sum stays what the ball brought, within the energy closure.",
      .x = {"time since first touch", "ms"},
      .y = {"energy", "J"}};
  for (const Channel& channel : channels) {
    std::vector<double> values;
    for (const EnergyBalance& balance : result.energies) values.push_back(balance.*channel.member);
    if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; }))
      continue;
    figure.series.push_back(
        line(channel.name, scaled(result.trace.time, milli), std::move(values)));
  }
  return figure;
}

report::Table scalars(const FemResult& result) {
  const ImpactScalars& s = result.scalars;
  report::Table table{.title = "Scalars",
                      .caption = "By the definitions that all tiers share.",
                      .columns = {{"quantity"}, {"value"}},
                      .rows = {}};
  const auto add = [&](const char* name, const char* unit, double value) {
    table.rows.push_back(
        {report::text_cell(name), report::text_cell(report::number_cell(value, 5).text + unit)});
  };
  add("restitution", "", s.restitution);
  add("rebound speed", " m/s", s.rebound_speed);
  add("contact time", " ms", 1e3 * s.contact_time);
  add("contact time above 1 % of the peak", " ms", 1e3 * s.contact_time_1pct);
  add("peak force", " N", s.peak_force);
  add("peak deflection of the centre of mass", " mm", 1e3 * s.peak_deflection);
  add("largest contact radius", " mm", 1e3 * result.contact_radius_peak);
  return table;
}

report::Table closures(const FemResult& result) {
  using Kind = report::TableColumn::Kind;
  using Verdict = report::TableCell::Verdict;
  report::Table table{
      .title = "Closures",
      .caption =
          "Impulse: force against the momentum of the nodes. Energy: all channels "
          "counted. Constraint: energy lost where nodes are caught by the plate.",
      .columns = {{"check"}, {"found", "1", Kind::number}, {"limit", "1", Kind::number}},
      .rows = {}};
  const auto add = [&](const char* name, double found, double limit) {
    table.rows.push_back({report::text_cell(name),
                          report::text_cell(fmt::format("{:.1e}", found),
                                            found <= limit ? Verdict::good : Verdict::doubtful),
                          report::text_cell(fmt::format("{:.0e}", limit))});
  };
  add("impulse", result.closures.impulse, 1e-6);
  add("energy", result.closures.energy, 1e-3);
  add("constraint", result.contact_constraint_share, 3e-3);
  return table;
}

report::Section inside(const FemProblem& problem, const FemResult& result) {
  report::Section section{.title = "Inside the ball", .blocks = {}};
  if (result.shapes.time.empty()) {
    section.blocks.push_back(report::Paragraph{fmt::format(
        "This run kept no shapes. `field_frames` under [controls] records stress, energy and "
        "contact pressure for this page and for ParaView, on up to {} cells here.",
        most_cells)});
    return section;
  }
  section.blocks.push_back(report::half_section(
      result.shapes, fmt::format("Half-section at {:g} m/s", problem.impact.speed),
      fmt::format("{} cells, drawn to scale.", result.cells)));
  return section;
}

}  // namespace

int animated_frames(int asked, int cells) {
  if (asked <= 0 || cells > most_cells) return 0;
  return std::min({asked, most_frames, most_cell_frames / std::max(cells, 1)});
}

report::Report impact_report(const FemProblem& problem, const FemResult& result) {
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::bad_input,
                "an incomplete impact has no report: " + result.incomplete_because);
  report::Report page{
      .title = fmt::format("FE impact at {:g} m/s", problem.impact.speed),
      .subtitle = fmt::format("{:.4g} g, {:.4g} mm, {} scheme, {} cells, {} steps",
                              1e3 * problem.sphere.mass, 1e3 * problem.sphere.diameter,
                              name_of(problem.scheme), result.cells, result.steps),
      .headline =
          fmt::format("The ball comes back at {:.3g} m/s, restitution {:.3f}, after {:.3g} ms of "
                      "contact and {:.0f} N at most.",
                      result.scalars.rebound_speed, result.scalars.restitution,
                      1e3 * result.scalars.contact_time, result.scalars.peak_force),
      .notices = {},
      .sections = {}};
  page.sections.push_back(
      {.title = "The impact",
       .blocks = {force_time(result.trace), force_deflection(result.trace), scalars(result)}});
  page.sections.push_back(inside(problem, result));
  page.sections.push_back(
      {.title = "Can it be believed?", .blocks = {energies(result), closures(result)}});
  return page;
}

}  // namespace rebound
