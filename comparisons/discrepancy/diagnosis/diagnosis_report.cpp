#include "comparisons/discrepancy/diagnosis/diagnosis_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "comparisons/discrepancy/diagnosis/diagnosis_pictures.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis_text.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/missing_force_pictures.hpp"
#include "comparisons/io/results/key_words.hpp"
#include "comparisons/io/toml/describe_effect.hpp"

namespace rebound {
namespace {

using report::number_cell;
using report::Origin;
using report::text_cell;
using Kind = report::TableColumn::Kind;

report::Notice::Level level_of(DiagnosisVerdict verdict) {
  using Level = report::Notice::Level;
  switch (verdict) {
    case DiagnosisVerdict::agrees:
    case DiagnosisVerdict::missing: return Level::finding;
    case DiagnosisVerdict::family:
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
    return after ? fmt::format("{:.3g} to {:.3g}", *before, *after)
                 : fmt::format("{:.3g}", *before);
  };
  std::string text =
      fmt::format("Gap {} (reduced whitened χ², the noise is 1)", step(d.gap.before, d.gap.after));
  if (d.held_out_speed && d.gap.held_out_before)
    text += fmt::format("; at {:g} m/s, which no fit saw, {}", *d.held_out_speed,
                        step(d.gap.held_out_before, d.gap.held_out_after));
  return text + fmt::format(". Noise from: {}.", d.seen->noise_from);
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
    const EffectCard& card = find_effect(fit.effects[k].name).card;
    const bool relative = has_logarithmic_size(card);
    const std::string unit = behind_number(size_unit(card));
    for (std::size_t ball = 0; ball < fit.model->sizes_of_effect(k); ++ball) {
      const double size = effects_of_ball(fit.effects, ball)[k].size,
                   error = fit.search.estimates[unknowns[ball]].standard_error;
      text += ball > 0 ? " | " : "";
      text += std::isfinite(error)
                  ? fmt::format("{:.3g} ± {:.2g}{}", size, relative ? size * error : error, unit)
                  : fmt::format("{:.3g}{}, not identifiable", size, unit);
    }
  }
  return text;
}

report::Table candidate_table(const Diagnosis& d) {
  report::Table table{.title = "Effects that were tried",
                      .caption =
                          "Size with one standard error, ball by ball where it was fitted so. "
                          "ΔBIC: over the best of all; "
                          "left: largest further Δχ² of any other effect, to be below the "
                          "limit beside it; not looked for where χ² is too large already or the "
                          "criterion beyond reach of the best.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "as named", Kind::text, Origin::fitted},
                                  {"χ² / dof", "1", Kind::number, {}},
                                  {"ΔBIC", "1", Kind::number, {}},
                                  {"left", "1", Kind::number, {}},
                                  {"limit", "1", Kind::number, {}},
                                  {"explains the data", "", Kind::text, {}}},
                      .rows = {}};
  const auto& tried = d.selection.tried;
  for (const AssessedFit& c : tried)
    table.rows.push_back(
        {text_cell(label_of(c.fit.effects)), text_cell(sizes_of(c.fit)),
         number_cell(c.fit.reduced_chi_square(), 3),
         text_cell(fmt::format(
             "{:.1f}", c.fit.information_criterion - tried.front().fit.information_criterion)),
         c.remaining_threshold > 0.0 ? number_cell(c.best_remaining, 3) : text_cell("–"),
         c.remaining_threshold > 0.0 ? number_cell(c.remaining_threshold, 3) : text_cell("–"),
         !c.judged    ? text_cell("–")
         : c.adequate ? text_cell("yes", report::TableCell::Verdict::good)
                      : text_cell("no", report::TableCell::Verdict::bad)});
  return table;
}

report::Table excluded_table(const Diagnosis& d) {
  report::Table table{.title = "Excluded above",
                      .caption =
                          "The largest size of each effect that these data leave possible, "
                          "at 95 %, one at a time, wherever its further numbers lie in the ranges "
                          "beside it.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "as named", Kind::number, Origin::derived},
                                  {"further numbers", "", Kind::text, {}}},
                      .rows = {}};
  for (const auto& e : d.excluded) {
    std::string over;
    for (const auto& range : e.over)
      over += fmt::format("{}{} {:.3g} to {:.3g}{}", over.empty() ? "" : ", ", range.parameter,
                          range.lowest, range.highest,
                          behind_number(parameter_unit(find_effect(e.name).card, range.parameter)));
    table.rows.push_back({text_cell(e.name), text_cell(size_text(find_effect(e.name).card, e.size)),
                          text_cell(over)});
  }
  return table;
}

report::Table check_table(const std::string& title, const std::string& caption,
                          const std::vector<DataCheck>& checks) {
  report::Table table{.title = title,
                      .caption = caption,
                      .columns = {{"check", "", Kind::text, {}},
                                  {"of", "", Kind::text, {}},
                                  {"measured", "as named", Kind::number, Origin::measured},
                                  {"expected", "as named", Kind::number, Origin::derived},
                                  {"deviation", "σ", Kind::number, Origin::derived},
                                  {"mended by", "", Kind::text, {}}},
                      .rows = {}};
  for (const DataCheck& one : checks)
    table.rows.push_back({text_cell(one.what), text_cell(one.of),
                          text_cell(fmt::format("{:.4g}{}", one.measured, behind_number(one.unit))),
                          text_cell(fmt::format("{:.4g}{}", one.expected, behind_number(one.unit))),
                          text_cell(fmt::format("{:+.1f}", one.deviations())),
                          text_cell(one.mended_by)});
  return table;
}

report::Table bootstrap_table(const SelectionBootstrap& bootstrap) {
  report::Table table{
      .title = "Chosen again",
      .caption =
          fmt::format("How often each set is the choice when the measurement is repeated with "
                      "other noise: {} draws from the best candidate, to first order.",
                      bootstrap.draws),
      .columns = {{"set", "", Kind::text, {}}, {"share", "%", Kind::number, Origin::derived}},
      .rows = {}};
  for (const SelectionFrequency& one : bootstrap.chosen)
    table.rows.push_back(
        {text_cell(one.effects.empty() ? "no effect"
                                       : fmt::format("{}", fmt::join(one.effects, " + "))),
         number_cell(100.0 * one.share, 3)});
  return table;
}

report::Table next_table(const Diagnosis& d) {
  report::Table table{.title = "Measure next",
                      .caption =
                          "P: chance that the right one of the two, whichever it is, then leads by "
                          "more than the close criterion, with the other fitted again.",
                      .columns = {{"experiment", "", Kind::text, {}},
                                  {"tells", "", Kind::text, {}},
                                  {"P", "1", Kind::number, Origin::predicted}},
                      .rows = {}};
  for (const auto& e : d.next)
    table.rows.push_back({text_cell(e.what), text_cell(e.separates[0] + " from " + e.separates[1]),
                          text_cell(fmt::format("{:.2f}", e.probability))});
  return table;
}

}  // namespace

std::vector<report::Section> diagnosis_sections(const Diagnosis& d, const std::string& name) {
  report::Section section{
      .title = "Diagnosis: " + name, .folding = report::Section::Folding::open, .blocks = {}};
  section.blocks.push_back(report::Notice{level_of(d.verdict), headline(d)});
  if (!d.contradictions.empty())
    section.blocks.push_back(
        check_table("The data contradict themselves",
                    "Found without any model of the contact. Deviations are in standard deviations "
                    "of the difference, all stated uncertainties in it.",
                    d.contradictions));
  std::vector<DataCheck> beside;
  std::copy_if(d.checks.begin(), d.checks.end(), std::back_inserter(beside),
               [](const DataCheck& one) { return one.compared_only; });
  if (!beside.empty())
    section.blocks.push_back(
        check_table("Measured beside the impacts",
                    "Slow compressions, block moduli and pooled peaks over what the believed model "
                    "gives, fitted to the impacts. A difference is no fault of the data.",
                    beside));
  if (d.seen) section.blocks.push_back(report::Paragraph{gap_sentence(d)});
  if (!d.withheld.empty())
    section.blocks.push_back(report::Paragraph{"No name: " + d.withheld + "."});
  for (const ExplainedShare& one : d.nearest)
    section.blocks.push_back(report::Paragraph{fmt::format(
        "The nearest formula of this family: {} explains {:.0f} % of the gap by itself.",
        one.effects.front(), 100.0 * one.share)});
  for (const auto& needed : d.needed)
    section.blocks.push_back(report::Paragraph{"Needed: " + needed + "."});
  if (!d.next.empty()) section.blocks.push_back(next_table(d));
  report::Section details{.title = "Diagnosis in detail: " + name,
                          .folding = report::Section::Folding::folded,
                          .blocks = {}};
  if (d.gap.before) {
    for (const FactorBand& band : d.curves)
      if (band.x.size() > 1) section.blocks.push_back(curve_figure(band));
    if (d.missing_force) {
      section.blocks.push_back(report::Paragraph{missing_force_sentence(d)});
      for (report::Figure& figure : missing_force_figures(*d.missing_force))
        section.blocks.push_back(std::move(figure));
    }
    section.blocks.push_back(map_matrix(d));
    add_pictures(d, section);
    if (!d.selection.tried.empty()) section.blocks.push_back(candidate_table(d));
    if (d.bootstrap.draws > 0) section.blocks.push_back(bootstrap_table(d.bootstrap));
    if (!d.excluded.empty()) section.blocks.push_back(excluded_table(d));
    if (!d.selection.cosines.names.empty()) details.blocks.push_back(cosine_matrix(d));
  }
  if (!d.checks.empty())
    details.blocks.push_back(
        check_table("The data against themselves", "Every check that these data allow.", d.checks));
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
  page.sections.push_back({.title = "Provenance",
                           .folding = report::Section::Folding::folded,
                           .blocks = {report::Verbatim{"Run", dump(to_json(provenance))}}});
  return page;
}

}  // namespace rebound
