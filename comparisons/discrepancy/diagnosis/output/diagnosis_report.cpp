#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_answers.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/missing_force_pictures.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_pictures.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_tables.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/discrepancy/diagnosis/output/shot_pictures.hpp"
#include "comparisons/io/results/key_words.hpp"

namespace rebound {
namespace {

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
  if (d.law_alone) {
    text += fmt::format(". The lumped law without what a body of finite size adds leaves {:.3g}",
                        *d.law_alone->before);
    if (d.law_alone->held_out_before)
      text += fmt::format(", at that speed {:.3g}", *d.law_alone->held_out_before);
  }
  return text + fmt::format(". Noise from: {}.", d.seen->noise_from);
}

report::Section where_section(const Diagnosis& d) {
  report::Section section{.title = "Where do model and data disagree?", .blocks = {}};
  if (!d.contradictions.empty())
    section.blocks.push_back(
        check_table("The data contradict themselves",
                    "Found without any model of the contact. Deviations are in standard deviations "
                    "of the difference, all stated uncertainties in it.",
                    d.contradictions));
  if (d.gap.before) {
    if (d.maps_the_law_alone())
      section.blocks.push_back(report::Paragraph{
          "Pictures and numbers of this section are those of the lumped law alone, without what a "
          "body of finite size adds to it."});
    section.blocks.push_back(map_matrix(d));
    ShotFigures figures = shot_figures(d);
    for (report::Figure& figure : figures.residuals) section.blocks.push_back(std::move(figure));
    for (report::Figure& figure : figures.histories) section.details.push_back(std::move(figure));
  }
  return section;
}

report::Section what_section(const Diagnosis& d) {
  report::Section section{.title = "What is missing?", .blocks = {}};
  section.blocks.push_back(
      report::Notice{level_of(d.verdict), headline(d), d.seen ? gap_sentence(d) : std::string()});
  if (!d.effects.empty()) section.blocks.push_back(found_table(d));
  if (!d.withheld.empty())
    section.blocks.push_back(report::Paragraph{"No name: " + d.withheld + "."});
  for (const ExplainedShare& one : d.nearest)
    section.blocks.push_back(report::Paragraph{fmt::format(
        "The nearest formula of this family: {} explains {:.0f} % of the gap by itself.",
        one.effects.front(), 100.0 * one.share)});
  for (const auto& needed : d.needed)
    section.blocks.push_back(report::Paragraph{"Needed: " + needed + "."});
  if (!d.next.empty()) section.blocks.push_back(next_table(d));
  for (const FactorBand& band : d.curves)
    if (band.x.size() > 1) section.blocks.push_back(curve_figure(band));
  if (d.missing_force) {
    section.blocks.push_back(report::Paragraph{missing_force_sentence(d)});
    for (report::Figure& figure : missing_force_figures(*d.missing_force))
      section.blocks.push_back(std::move(figure));
  }
  return section;
}

report::Section certainty_section(const Diagnosis& d, std::vector<report::Block> measured) {
  report::Section section{.title = "How sure is that?", .blocks = std::move(measured)};
  std::vector<DataCheck> beside;
  std::copy_if(d.checks.begin(), d.checks.end(), std::back_inserter(beside),
               [](const DataCheck& one) { return one.compared_only; });
  if (!beside.empty())
    section.blocks.push_back(
        check_table("Measured beside the impacts",
                    "Slow compressions, block moduli and pooled peaks over what the believed model "
                    "gives, fitted to the impacts. A difference is no fault of the data.",
                    beside));
  if (d.gap.before) {
    if (d.bootstrap.draws > 0) section.blocks.push_back(bootstrap_table(d.bootstrap));
    if (!d.selection.tried.empty()) section.blocks.push_back(candidate_table(d));
    if (!d.excluded.empty()) section.blocks.push_back(excluded_table(d));
    if (!d.selection.cosines.names.empty()) section.details.push_back(cosine_matrix(d));
  }
  if (!d.checks.empty())
    section.details.push_back(
        check_table("The data against themselves", "Every check that these data allow.", d.checks));
  for (const auto& warning : d.warnings)
    section.blocks.push_back(report::Notice{report::Notice::Level::warning, warning});
  return section;
}

bool holds_something(const report::Section& section) {
  return !section.blocks.empty() || !section.details.empty();
}

}  // namespace

report::Report diagnosis_report(const Diagnosis& d, const std::string& name,
                                const Provenance& provenance, MeasuredErrorRates error_rates) {
  report::Report page;
  page.title = "Diagnosis: " + name;
  page.subtitle = "A believed model against data";
  page.question = "Where do model and data disagree, what is missing, and how sure is that?";
  page.headline = headline(d);
  for (const NamedEffect& one : d.effects)
    page.lead.push_back(report::Paragraph{effect_sentence(d, one)});
  if (d.seen) page.lead.push_back(report::Paragraph{gap_sentence(d)});
  if (!error_rates.sentence.empty()) page.lead.push_back(report::Paragraph{error_rates.sentence});
  if (const std::string text = fem_sentence(d); !text.empty())
    page.lead.push_back(report::Paragraph{text});
  if (const std::vector<std::string> balls = fem_balls_in_words(d); !balls.empty())
    page.lead.push_back(report::Paragraph{
        fmt::format("FE's own ball {}: {}. E is long-term, branches are over it.",
                    d.fem_alone->plate_moves() ? "on the plate that FE has found under it"
                                               : "with nothing hidden",
                    fmt::join(balls, "; "))});
  if (!d.in_fem.empty()) page.lead.push_back(tiers_table(d));
  if (d.gap.before)
    if (report::Figure gaps = gap_figure(d); !gaps.series.empty())
      page.lead.push_back(std::move(gaps));
  std::array sections{where_section(d), what_section(d),
                      certainty_section(d, std::move(error_rates.blocks))};
  for (report::Section& section : sections)
    if (holds_something(section)) page.sections.push_back(std::move(section));
  page.sections.push_back({.title = "Provenance",
                           .folding = report::Section::Folding::folded,
                           .blocks = {report::Verbatim{"Run", dump(to_json(provenance))}}});
  return page;
}

}  // namespace rebound
