#include <fmt/format.h>

#include <cmath>

#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Verdict = report::TableCell::Verdict;
using Kind = report::TableColumn::Kind;

/// Distance in standard deviations; two are within what noise does.
report::TableCell deviation_cell(double deviations) {
  const double size = std::abs(deviations);
  const Verdict verdict = size < 2 ? Verdict::good : size < 4 ? Verdict::doubtful : Verdict::bad;
  return report::text_cell(fmt::format("{:+.1f}", deviations), verdict);
}

report::Table fitted_table(const std::vector<CoreStudy>& cores) {
  report::Table table{
      .title = "What the FE material was fitted to",
      .caption =
          "Deviations in standard deviations of the measurement, as the "
          "data set states or assumes them.",
      .columns = {{"impact", "", Kind::text, {}},
                  {"restitution measured", "1", Kind::number, report::Origin::measured},
                  {"FE", "1", Kind::number, report::Origin::fitted},
                  {"deviation", "σ", Kind::number, {}},
                  {"contact time measured", "ms", Kind::number, report::Origin::measured},
                  {"FE, above threshold", "ms", Kind::number, report::Origin::fitted},
                  {"deviation", "σ", Kind::number, {}}},
      .rows = {}};
  for (const auto& core : cores)
    for (const auto& shot : core.shots) {
      const auto& e = shot.measured.restitution;
      const auto& t = shot.measured.contact_time;
      table.rows.push_back(
          {report::text_cell(
               fmt::format("core {}, {:g} m/s", core.label, shot.measured.impact.speed)),
           report::uncertain_cell(*e.value, *e.uncertainty),
           report::number_cell(shot.fem.scalars.restitution, 3),
           deviation_cell((shot.fem.scalars.restitution - *e.value) / *e.uncertainty),
           report::uncertain_cell(1e3 * *t.value, 1e3 * *t.uncertainty),
           report::number_cell(1e3 * shot.contact_time, 3),
           deviation_cell((shot.contact_time - *t.value) / *t.uncertainty)});
    }
  return table;
}

/// Against numbers without a stated uncertainty: per cent, no verdict of noise.
report::TableCell percent_cell(double model, double measured) {
  const double error = model / measured - 1;
  const Verdict verdict = std::abs(error) < 0.05   ? Verdict::good
                          : std::abs(error) < 0.15 ? Verdict::doubtful
                                                   : Verdict::bad;
  return report::text_cell(fmt::format("{:+.0f}", 100 * error), verdict);
}

report::Table check_table(const std::vector<CoreStudy>& cores) {
  report::Table table{
      .title = "What it was not fitted to",
      .caption =
          "Mean deflection of the core; peak force and deflection only as the paper's prose "
          "gives them, typical of four cores together. Good within 5 %, bad beyond 15 %.",
      .columns = {{"impact", "", Kind::text, {}},
                  {"mean deflection measured", "mm", Kind::number, report::Origin::measured},
                  {"FE", "mm", Kind::number, report::Origin::predicted},
                  {"difference", "%", Kind::number, {}},
                  {"typical peak force", "N", Kind::number, report::Origin::measured},
                  {"FE", "N", Kind::number, report::Origin::predicted},
                  {"difference", "%", Kind::number, {}},
                  {"typical peak deflection", "mm", Kind::number, report::Origin::measured},
                  {"FE", "mm", Kind::number, report::Origin::predicted},
                  {"difference", "%", Kind::number, {}}},
      .rows = {}};
  for (const auto& core : cores)
    for (const auto& shot : core.shots) {
      const ImpactScalars& fem = shot.fem.scalars;
      std::vector<report::TableCell> row = {report::text_cell(
          fmt::format("core {}, {:g} m/s", core.label, shot.measured.impact.speed))};
      const auto add = [&](std::optional<double> measured, double model, double factor) {
        row.push_back(measured ? report::number_cell(factor * *measured, 3)
                               : report::text_cell("–"));
        row.push_back(report::number_cell(factor * model, 3));
        row.push_back(measured ? percent_cell(model, *measured) : report::text_cell("–"));
      };
      std::optional<double> force;
      std::optional<double> deflection;
      for (const auto& peak : core.data.pooled_peaks)
        if (peak.speed == shot.measured.impact.speed)
          force = peak.force, deflection = peak.deflection;
      add(shot.measured.mean_deflection.value, fem.mean_deflection, 1e3);
      add(force, fem.peak_force, 1);
      add(deflection, fem.peak_deflection, 1e3);
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// What a fit with one material cannot do is said, with its size.
report::Notice misfit_notice(const CoreStudy& core) {
  std::string worst;
  double size = 0.0;
  for (const auto& shot : core.shots) {
    const auto look = [&](const char* name, double deviation) {
      if (std::abs(deviation) <= size) return;
      size = std::abs(deviation);
      worst = fmt::format("{} at {:g} m/s, {:+.1f} standard deviations", name,
                          shot.measured.impact.speed, deviation);
    };
    look("restitution", (shot.fem.scalars.restitution - *shot.measured.restitution.value) /
                            *shot.measured.restitution.uncertainty);
    look("contact time", (shot.contact_time - *shot.measured.contact_time.value) /
                             *shot.measured.contact_time.uncertainty);
  }
  if (fem_follows(core))
    return {report::Notice::Level::finding,
            fmt::format("Core {}: the material follows restitution and contact time within their "
                        "uncertainty (reduced χ² {:.2g}).",
                        core.label, core.material.fit.reduced_chi_square)};
  const std::string contradiction = contradiction_of(core);
  return {report::Notice::Level::failure,
          fmt::format("Core {}: this material cannot follow the measurement (reduced χ² {:.0f}, "
                      "noise 1).",
                      core.label, core.material.fit.reduced_chi_square),
          fmt::format("Furthest off: {}. One set of branches, the same at all speeds, is what was "
                      "fitted; damping that depends on amplitude, a plate that moves or air are "
                      "not in it. Laws calibrated to this FE model share its error.{}{}",
                      worst, contradiction.empty() ? "" : " ", contradiction)};
}

}  // namespace

report::Section check_section(const std::vector<CoreStudy>& cores) {
  report::Section section{.title = "Can the FE reference be believed?", .blocks = {}};
  for (const auto& core : cores) section.blocks.push_back(misfit_notice(core));
  section.blocks.push_back(check_table(cores));
  section.details.push_back(fitted_table(cores));
  return section;
}

}  // namespace rebound
