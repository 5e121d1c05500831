#include "comparisons/evaluation/atlas/atlas_text.hpp"

#include <fmt/format.h>

#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {

void describe(Visitor& visit, AtlasGrid& grid) {
  describe_schema(visit);
  visit.numbers({.name = "speeds",
                 .sentence = "Speeds over the wave speed.",
                 .presence = Presence::optional,
                 .range = above_up_to(0.0, 0.3)},
                grid.speeds);
  visit.numbers({.name = "loss_factors",
                 .sentence = "Loss factors at the reference speed's contact.",
                 .presence = Presence::optional,
                 .range = above_up_to(0.0, 2.0)},
                grid.loss_factors);
  visit.numbers({.name = "poisson_ratios",
                 .sentence = "Poisson ratios.",
                 .presence = Presence::optional,
                 .range = above_up_to(0.0, 0.45)},
                grid.poisson_ratios);
  visit.numbers({.name = "relaxation_times",
                 .sentence = "Relaxation times over the contact time.",
                 .presence = Presence::optional,
                 .range = above_up_to(0.0, 100.0)},
                grid.relaxation_times);
  visit.whole({.name = "cells",
               .sentence = "Cells of the mesh.",
               .presence = Presence::optional,
               .range = from_to(60.0, 20000.0)},
              grid.cells);
}

namespace {

Json spreads_json(const Atlas& atlas) {
  Json list = Json::array();
  const std::size_t speeds = atlas.grid.speeds.size();
  for (std::size_t law = 0; law < atlas_laws().size(); ++law)
    for (std::size_t from = 0; from < speeds; ++from)
      for (std::size_t to = 0; to < speeds; ++to) {
        Json entry = {{"law", atlas_laws()[law].label},
                      {"calibrated_at", atlas.grid.speeds[from]},
                      {"used_at", atlas.grid.speeds[to]}};
        for (const auto& quantity : atlas_quantities()) {
          const AtlasSpread s = spread_of(atlas, quantity, law, from, to);
          entry[quantity.name] = {{"median", s.median},
                                  {"ninetieth", s.ninetieth},
                                  {"cells", s.cells},
                                  {"failures", s.failures}};
        }
        list.push_back(entry);
      }
  return list;
}

Json advice_json(const Atlas& atlas) {
  Json list = Json::array();
  const std::size_t speeds = atlas.grid.speeds.size();
  for (const auto& entry : atlas.entries)
    for (std::size_t from = 0; from < speeds; ++from)
      for (std::size_t to = 0; to < speeds; ++to) {
        const AtlasAdvice advice = advice_of(entry, from, to);
        const bool any = advice.law >= 0;
        list.push_back({{"loss_factor", entry.material.loss_factor},
                        {"poisson_ratio", entry.material.poisson_ratio},
                        {"relaxation_time", entry.material.relaxation_time},
                        {"calibrated_at", atlas.grid.speeds[from]},
                        {"used_at", atlas.grid.speeds[to]},
                        {"law", any ? Json(atlas_laws()[static_cast<std::size_t>(advice.law)].label)
                                    : Json(nullptr)},
                        {"force_rms", any ? Json(advice.force_rms) : Json(nullptr)},
                        {"restitution_error", any ? Json(advice.restitution) : Json(nullptr)}});
      }
  return list;
}

}  // namespace

Json to_json(const Atlas& atlas) {
  int failed = 0;
  Json laws = Json::array();
  for (const auto& law : atlas_laws()) laws.push_back(law.label);
  for (const auto& entry : atlas.entries)
    for (const auto& impact : entry.impacts) failed += !impact.failure.empty();
  return {{"schema", 1},
          {"grid",
           {{"speeds", atlas.grid.speeds},
            {"loss_factors", atlas.grid.loss_factors},
            {"poisson_ratios", atlas.grid.poisson_ratios},
            {"relaxation_times", atlas.grid.relaxation_times},
            {"cells", atlas.grid.cells}}},
          {"laws", laws},
          {"materials", atlas.entries.size()},
          {"impacts", atlas.entries.size() * atlas.grid.speeds.size()},
          {"impacts_failed", failed},
          {"impacts_run", atlas.impacts_run},
          {"impact_wall_s", atlas.impact_seconds},
          {"spreads", spreads_json(atlas)},
          {"best", advice_json(atlas)}};
}

std::string to_csv(const Atlas& atlas) {
  std::string text =
      "poisson_ratio,loss_factor,relaxation_time,law,calibrated_at,used_at,force_rms,"
      "restitution_error,contact_time_error,peak_force_error,peak_deflection_error\n";
  const std::size_t speeds = atlas.grid.speeds.size();
  for (const auto& entry : atlas.entries)
    for (std::size_t law = 0; law < atlas_laws().size(); ++law)
      for (std::size_t from = 0; from < speeds; ++from)
        for (std::size_t to = 0; to < speeds; ++to) {
          const AtlasCell& c = entry.cells[law][from][to];
          const auto& m = entry.material;
          text += fmt::format("{},{},{},\"{}\",{},{},", m.poisson_ratio, m.loss_factor,
                              m.relaxation_time, atlas_laws()[law].label, atlas.grid.speeds[from],
                              atlas.grid.speeds[to]);
          text += c.failure.empty() ? fmt::format("{},{},{},{},{}\n", c.force_rms, c.restitution,
                                                  c.contact_time, c.peak_force, c.peak_deflection)
                                    : ",,,,\n";
        }
  return text;
}

std::string to_text(const Atlas& atlas) {
  const std::size_t middle = atlas.grid.speeds.size() / 2;
  std::string text = fmt::format(
      "calibrated at v/c = {:g}; median (90th percentile) over {} materials, "
      "in per cent\n",
      atlas.grid.speeds[middle], atlas.entries.size());
  for (const auto& quantity : atlas_quantities()) {
    text += fmt::format("\n{}\n{:<26}", quantity.name, "used at v/c");
    for (double speed : atlas.grid.speeds) text += fmt::format("{:>16g}", speed);
    text += "\n";
    for (std::size_t law = 0; law < atlas_laws().size(); ++law) {
      text += fmt::format("{:<26}", atlas_laws()[law].label);
      for (std::size_t to = 0; to < atlas.grid.speeds.size(); ++to) {
        const AtlasSpread s = spread_of(atlas, quantity, law, middle, to);
        text += s.cells == 0
                    ? fmt::format("{:>16}", "-")
                    : fmt::format("{:>8.1f} ({:>5.1f})", 100.0 * s.median, 100.0 * s.ninetieth);
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace rebound
