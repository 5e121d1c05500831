#include <fmt/format.h>

#include "comparisons/io/report/half_section.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;
using Verdict = report::TableCell::Verdict;

report::TableCell limited(double value, double limit) {
  return report::text_cell(fmt::format("{:.1e}", value),
                           value <= limit ? Verdict::good : Verdict::bad);
}

report::TableCell relative_spread(const StudyShot& shot, double ImpactScalars::*scalar) {
  return report::text_cell(
      fmt::format("{:.2f}", 100 * spread(shot, scalar) / (shot.fem.scalars.*scalar)));
}

/// Every second shape: half of what is by far the largest part of the page.
ShapeHistory every_second(const ShapeHistory& shapes) {
  ShapeHistory kept = shapes;
  const auto thin = [](auto& rows) {
    for (std::size_t i = 0; 2 * i < rows.size(); ++i) rows[i] = rows[2 * i];
    rows.resize((rows.size() + 1) / 2);
  };
  thin(kept.time);
  thin(kept.positions);
  for (ShapeField& field : kept.fields) thin(field.values);
  if (!kept.contact_vertices.empty()) thin(kept.contact_pressure);
  return kept;
}

/// The impact with the largest deflection over diameter, as the coarse mesh shows it.
report::Animation deepest_impact(const std::vector<CoreStudy>& cores) {
  const CoreStudy* core = nullptr;
  const StudyShot* shot = nullptr;
  double deepest = -1.0;
  for (const auto& candidate : cores)
    for (const auto& impact : candidate.shots) {
      const double depth = impact.fem.scalars.peak_deflection / candidate.data.sphere.diameter;
      if (depth <= deepest) continue;
      deepest = depth;
      core = &candidate;
      shot = &impact;
    }
  if (!shot) throw Error(ExitCode::bad_input, "a study without impacts has nothing to show");
  return report::half_section(
      every_second(shot->fem_coarse.shapes),
      fmt::format("Core {} at {:g} m/s, half-section", core->label, shot->measured.impact.speed),
      fmt::format("The deepest impact of this study: the centre of mass moves by {:.1f} % of the "
                  "diameter. Mesh of {} cells, drawn to scale.",
                  100 * deepest, shot->fem_coarse.cells));
}

}  // namespace

report::Section credibility_section(const std::vector<CoreStudy>& cores) {
  report::Section section{.title = "Can the FE reference be believed?", .blocks = {}};
  report::Table closures{.title = "Closures",
                         .caption =
                             "Impulse: ∫F dt against the momentum of the nodes, limit 1e-6. "
                             "Energy: all channels counted, limit 1e-3. Constraint: energy "
                             "lost where nodes are caught by the plate, limit 3e-3.",
                         .columns = {{"impact", "", Kind::text, {}},
                                     {"cells", "1", Kind::number, {}},
                                     {"steps", "1", Kind::number, {}},
                                     {"impulse", "1", Kind::number, {}},
                                     {"energy", "1", Kind::number, {}},
                                     {"constraint", "1", Kind::number, {}},
                                     {"vibration left", "1", Kind::number, {}}},
                         .rows = {}};
  report::Table spreads{.title = "Distance between the two meshes",
                        .caption = "A first measure of the discretisation error, not an error bar.",
                        .columns = {{"impact", "", Kind::text, {}},
                                    {"cells", "", Kind::text, {}},
                                    {"restitution", "%", Kind::number, {}},
                                    {"contact time", "%", Kind::number, {}},
                                    {"peak force", "%", Kind::number, {}},
                                    {"peak deflection", "%", Kind::number, {}}},
                        .rows = {}};
  for (const auto& core : cores)
    for (const auto& shot : core.shots) {
      const auto name = report::text_cell(
          fmt::format("core {}, {:g} m/s", core.label, shot.measured.impact.speed));
      const FemResult& fem = shot.fem;
      closures.rows.push_back(
          {name, report::text_cell(std::to_string(fem.cells)),
           report::text_cell(std::to_string(fem.steps)), limited(fem.closures.impulse, 1e-6),
           limited(fem.closures.energy, 1e-3), limited(fem.contact_constraint_share, 3e-3),
           report::text_cell(fmt::format("{:.1e}", fem.vibrational_energy_share))});
      spreads.rows.push_back(
          {name, report::text_cell(fmt::format("{} and {}", shot.fem_coarse.cells, fem.cells)),
           relative_spread(shot, &ImpactScalars::restitution),
           relative_spread(shot, &ImpactScalars::contact_time),
           relative_spread(shot, &ImpactScalars::peak_force),
           relative_spread(shot, &ImpactScalars::peak_deflection)});
    }
  section.blocks.push_back(std::move(closures));
  section.blocks.push_back(std::move(spreads));
  section.blocks.push_back(deepest_impact(cores));
  return section;
}

}  // namespace rebound
