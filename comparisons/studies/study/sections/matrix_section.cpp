#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Score = std::function<std::optional<double>(const LawScore&)>;
/// Numerical share of a score that the FE reference itself is uncertain by.
using NumericalSpread = std::function<double(const StudyShot&)>;

struct MatrixKind {
  std::string title;
  std::string caption;
  std::string quantity;
  report::ColourScale scale;
  Score score;
  NumericalSpread spread;
};

report::MatrixCell cell_of(const LawScore& cell, const StudyShot& shot, const MatrixKind& kind,
                           const std::string& law) {
  report::MatrixCell shown;
  const auto score = cell.failure.empty() ? kind.score(cell) : std::nullopt;
  if (!score) {
    shown.text = cell.failure.empty() ? "not measured" : "no answer";
    return shown;
  }
  // What rounds to zero is zero, without a sign.
  shown.value = std::abs(*score) < 5e-4 ? 0.0 : 100 * *score;
  shown.text = kind.scale.kind == report::ColourScale::Kind::diverging && *shown.value != 0.0
                   ? fmt::format("{:+.1f}", *shown.value)
                   : fmt::format("{:.1f}", *shown.value);
  shown.hatched = std::abs(*score) < kind.spread(shot);
  shown.highlight = law;
  return shown;
}

report::Matrix matrix_of(const std::vector<CoreStudy>& cores, const MatrixKind& kind) {
  report::Matrix matrix;
  matrix.title = kind.title;
  matrix.caption = kind.caption;
  matrix.quantity = kind.quantity;
  matrix.unit = "%";
  matrix.row_heading = "law";
  matrix.hatching = "smaller than the numerical spread of the FE reference";
  matrix.scale = kind.scale;
  matrix.overlays = "impacts";
  for (const auto& law : cores.front().laws) matrix.rows.push_back({law.label, {}});
  for (const auto& core : cores)
    for (std::size_t s = 0; s < core.shots.size(); ++s) {
      matrix.columns.push_back(
          {"core " + core.label, fmt::format("{:g} m/s", core.shots[s].measured.impact.speed)});
      for (std::size_t l = 0; l < core.laws.size(); ++l) {
        auto cell = cell_of(core.benchmark.cells[l][s], core.shots[s], kind, core.laws[l].label);
        cell.overlay = overlay_key(core, core.shots[s]);
        matrix.rows[l].cells.push_back(std::move(cell));
      }
    }
  return matrix;
}

double relative_force_spread(const StudyShot& shot) {
  return spread(shot, &ImpactScalars::peak_force) / shot.fem.scalars.peak_force;
}

double no_spread(const StudyShot&) {
  return 0.0;
}

}  // namespace

report::Matrix restitution_matrix(const std::vector<CoreStudy>& cores) {
  return matrix_of(
      cores, {.title = "How wrong is each law?",
              .caption = "Restitution of the law over the measured one, less one. A press on a "
                         "cell shows the impact.",
              .quantity = "error of the restitution",
              .scale = {report::ColourScale::Kind::diverging, 40.0},
              .score = [](const LawScore& cell) { return cell.against_measured.restitution; },
              .spread = no_spread});
}

report::Section matrix_section(const std::vector<CoreStudy>& cores) {
  using Kind = report::ColourScale::Kind;
  report::Section section{.title = "Which law holds where?", .blocks = {}};
  section.blocks.push_back(
      report::Paragraph{"Each cell is one law at one impact. A click shows the curves below."});
  section.blocks.push_back(matrix_of(
      cores, {.title = "Force history against FE",
              .caption = "Root mean square of the force difference over time, in per cent of the "
                         "FE peak force.",
              .quantity = "difference of the force history",
              .scale = {Kind::sequential, 20.0},
              .score = [](const LawScore& cell) { return std::optional(cell.force_time_rms); },
              .spread = relative_force_spread}));
  section.details.push_back(matrix_of(
      cores, {.title = "Peak force against FE",
              .caption = "Law over FE, less one.",
              .quantity = "error of the peak force",
              .scale = {Kind::diverging, 20.0},
              .score = [](const LawScore& cell) { return cell.against_reference.peak_force; },
              .spread = relative_force_spread}));
  section.details.push_back(matrix_of(
      cores, {.title = "Contact time against the measurement",
              .caption = "Law, by its separation rule, over measured contact time, less one.",
              .quantity = "error of the contact time",
              .scale = {Kind::diverging, 20.0},
              .score = [](const LawScore& cell) { return cell.against_measured.contact_time; },
              .spread = no_spread}));
  return section;
}

}  // namespace rebound
