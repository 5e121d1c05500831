#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/results/key_words.hpp"
#include "comparisons/studies/study/believed_simulation.hpp"
#include "comparisons/studies/study/sections/observable_words.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;

/// "26 % longer than", of measured over modelled.
std::string against(const ObservableRatio& ratio) {
  return fmt::format("{:.0f} % {} than", 100 * std::abs(ratio.mean - 1.0),
                     direction_in_words(ratio.what, ratio.mean > 1.0));
}

/// One kind whose absence lets the rest agree.
const ConsistencyFit* odd_one_out(const ScalarDiagnosis& d) {
  const ConsistencyFit* best = d.consistency.best();
  if (d.consistency.all.fit.reduced_chi_square() <= agreeing) return nullptr;
  return best && best->fit.reduced_chi_square() <= agreeing ? best : nullptr;
}

std::string effect_sentence(const ScalarDiagnosis& d) {
  if (d.effects.empty()) return "No effect of the list brings it closer.";
  std::string text =
      fmt::format("The effect that comes nearest is {}: the gap goes from {:.2g} to {:.2g}",
                  d.effects.front().effect.name, d.believed.fitted, d.extended.fitted);
  if (d.unseen_speed)
    text += fmt::format(", and at {:g} m/s, which no fit saw, from {:.2g} to {:.2g}: {}",
                        *d.unseen_speed, *d.believed.unseen, *d.extended.unseen,
                        earns_a_name(d) ? "more than half of it, and the name stands"
                                        : "less than half of it, so that it earns no name");
  return text + ".";
}

report::Notice finding_of(const CoreStudy& core) {
  const ScalarDiagnosis& d = *core.scalars;
  const double all = d.consistency.all.fit.reduced_chi_square();
  report::Notice notice{
      .level = report::Notice::Level::finding, .text = {}, .evidence = effect_sentence(d)};
  if (const ConsistencyFit* odd = odd_one_out(d)) {
    const ObservableRatio& ratio = odd->of(*odd->left_out);
    std::vector<std::string> shots;
    for (std::size_t i = 0; i < ratio.of_shots.size(); ++i)
      if (std::isfinite(ratio.of_shots[i]))
        shots.push_back(fmt::format("{:+.0f} % at {:g} m/s", 100 * (ratio.of_shots[i] - 1.0),
                                    d.all.shots[i].impact.speed));
    notice.text = fmt::format(
        "Core {}: {} contradicts the rest. No material of this kind holds all scalars (reduced χ² "
        "{:.2g}); without {} the others agree ({:.2g}), and it was measured {} they allow ({}).",
        core.label, in_words(*odd->left_out), all, in_words(*odd->left_out),
        odd->fit.reduced_chi_square(), against(ratio), fmt::join(shots, ", "));
  } else if (all <= agreeing) {
    notice.text = fmt::format("Core {}: one material holds all scalars (reduced χ² {:.2g}).",
                              core.label, all);
  } else {
    notice.level = report::Notice::Level::abstention;
    notice.text = fmt::format(
        "Core {}: no material of this kind holds all scalars (reduced χ² {:.2g}), and leaving one "
        "kind of them out does not mend it (best without {}: {:.2g}).",
        core.label, all, d.consistency.best() ? in_words(*d.consistency.best()->left_out) : "none",
        d.consistency.best() ? d.consistency.best()->fit.reduced_chi_square() : all);
  }
  return notice;
}

/// Measured over simulated by the fit that never saw that kind of observable.
report::Matrix contradiction_matrix(const std::vector<CoreStudy>& cores) {
  report::Matrix matrix{.title = "What the other observables say of each",
                        .caption =
                            "Measured over simulated, less one; the material was fitted to "
                            "all kinds but the one of that row.",
                        .quantity = "measured over simulated, less one",
                        .unit = "%",
                        .row_heading = "left out",
                        .hatching = "the rest does not agree without it either",
                        .scale = {report::ColourScale::Kind::diverging, 40.0},
                        .overlays = "impacts",
                        .columns = {},
                        .rows = {}};
  for (const ScalarQuantity& scalar : scalar_quantities)
    matrix.rows.push_back({in_words(scalar.what), {}});
  for (const CoreStudy& core : cores) {
    if (!core.scalars) continue;
    for (std::size_t i = 0; i < core.shots.size(); ++i) {
      matrix.columns.push_back(
          {"core " + core.label, fmt::format("{:g} m/s", core.shots[i].measured.impact.speed)});
      for (std::size_t k = 0; k < scalar_quantities.size(); ++k) {
        report::MatrixCell cell{.value = {}, .text = "–", .overlay = {}, .highlight = {}};
        for (const ConsistencyFit& fit : core.scalars->consistency.without)
          if (fit.left_out == scalar_quantities[k].what) {
            const double error = 100 * (fit.of(scalar_quantities[k].what).of_shots[i] - 1.0);
            if (!std::isfinite(error)) continue;
            cell = {.value = error,
                    .text = fmt::format("{:+.0f}", error),
                    .hatched = fit.fit.reduced_chi_square() > agreeing,
                    .overlay = overlay_key(core, core.shots[i]),
                    .highlight = {}};
          }
        matrix.rows[k].cells.push_back(std::move(cell));
      }
    }
  }
  return matrix;
}

report::Table fit_table(const std::vector<CoreStudy>& cores) {
  report::Table table{
      .title = "Fits with one kind of observable left out",
      .caption =
          "Reduced χ² of what was fitted, 1 for noise alone. Mean deflections and pooled "
          "peaks count with the shares of uncertainty that the study file assumes.",
      .columns = {{"ball", "", Kind::text, {}}, {"all", "noise = 1", Kind::number, {}}},
      .rows = {}};
  for (const ScalarQuantity& scalar : scalar_quantities)
    table.columns.push_back({"without " + in_words(scalar.what), "noise = 1", Kind::number, {}});
  for (const CoreStudy& core : cores) {
    if (!core.scalars) continue;
    const ObservableConsistency& one = core.scalars->consistency;
    table.rows.push_back({report::text_cell("core " + core.label),
                          report::number_cell(one.all.fit.reduced_chi_square(), 3)});
    for (const ScalarQuantity& scalar : scalar_quantities) {
      const auto fit = std::find_if(one.without.begin(), one.without.end(),
                                    [&](const auto& f) { return f.left_out == scalar.what; });
      table.rows.back().push_back(fit == one.without.end()
                                      ? report::text_cell("–")
                                      : report::number_cell(fit->fit.reduced_chi_square(), 3));
    }
  }
  return table;
}

report::Table effect_table(const std::vector<CoreStudy>& cores) {
  report::Table table{.title = "Effects beside the FE model",
                      .caption =
                          "Fitted to all scalars but those of the unseen speed; those that "
                          "bring the model closer, best first.",
                      .columns = {{"ball", "", Kind::text, {}},
                                  {"effect", "", Kind::text, {}},
                                  {"family", "", Kind::text, {}},
                                  {"size", "", Kind::text, report::Origin::fitted},
                                  {"reduced χ²", "noise = 1", Kind::number, {}},
                                  {"criterion", "1", Kind::number, {}}},
                      .rows = {}};
  for (const CoreStudy& core : cores)
    if (core.scalars)
      for (const EffectOnScalars& one : core.scalars->effects)
        table.rows.push_back({report::text_cell("core " + core.label),
                              report::text_cell(one.effect.name),
                              report::text_cell(name_of(one.family)),
                              report::text_cell(fmt::format(
                                  "{:.3g}{}", one.effect.size,
                                  behind_number(size_unit(find_effect(one.effect.name).card)))),
                              report::number_cell(one.reduced_chi_square, 3),
                              report::number_cell(one.information_criterion, 4)});
  return table;
}

}  // namespace

std::string simulation_clause(const std::vector<CoreStudy>& cores) {
  std::vector<std::string> labels;
  std::vector<double> slowest, fastest;
  std::optional<ObservedQuantity> kind;
  std::size_t diagnosed = 0;
  for (const CoreStudy& core : cores) {
    if (!core.scalars) continue;
    ++diagnosed;
    const ConsistencyFit* odd = odd_one_out(*core.scalars);
    if (!odd || (kind && *kind != *odd->left_out)) continue;
    kind = *odd->left_out;
    labels.push_back(core.label);
    const std::vector<double>& shots = odd->of(*kind).of_shots;  // in the order of the data
    slowest.push_back(100 * (shots.front() - 1.0));
    fastest.push_back(100 * (shots.back() - 1.0));
  }
  if (!kind) return {};
  return fmt::format(
      "no FE material of the believed law holds all that was measured of {} of {} cores, for {} "
      "exceeds what the rest allows by {} at the lowest speed and by {} at the highest",
      labels.size(), diagnosed, in_words(*kind), percent_range(slowest), percent_range(fastest));
}

std::string contradiction_of(const CoreStudy& core) {
  const ConsistencyFit* odd = core.scalars ? odd_one_out(*core.scalars) : nullptr;
  if (!odd) return {};
  return fmt::format(
      "The scalars of this ball contradict each other: without {} one material holds all others "
      "(reduced χ² {:.2g}).",
      in_words(*odd->left_out), odd->fit.reduced_chi_square());
}

std::vector<report::Section> simulation_section(const std::vector<CoreStudy>& cores,
                                                const std::optional<JointScalars>& joint) {
  if (std::none_of(cores.begin(), cores.end(), [](const auto& core) { return core.scalars; }))
    return {};
  report::Section section{.title = "Which measurements contradict each other?", .blocks = {}};
  section.blocks.push_back(report::Paragraph{
      "The FE model is believed, and its material fitted to everything that was measured of a "
      "ball. Then one kind of observable after the other is left out: where the rest agrees "
      "without it, its row says by how much it would have to be wrong."});
  if (joint) section.blocks.push_back(joint_contradiction(cores, *joint));
  section.blocks.push_back(contradiction_matrix(cores));
  if (joint) {
    section.blocks.push_back(joint_effect(cores, *joint));
    section.blocks.push_back(gap_matrix(cores, *joint));
  }
  for (const CoreStudy& core : cores)
    if (core.scalars) section.blocks.push_back(finding_of(core));
  section.details = {fit_table(cores), effect_table(cores)};
  if (joint)
    for (report::Table& table : joint_tables(cores, *joint)) section.details.push_back(table);
  return {section};
}

}  // namespace rebound
