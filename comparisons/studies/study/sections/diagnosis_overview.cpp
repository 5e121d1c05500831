#include <fmt/format.h>

#include <cctype>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_report.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;

std::string core_name(const CoreStudy& core) {
  return fmt::format("core {}, the paper's Eq. (8) model", core.label);
}

/// Letters and digits of a label, and its place, so that no two pages share a file.
std::string page_file(std::size_t place, const std::string& label) {
  std::string plain;
  for (const char c : label) plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
  return fmt::format("diagnosis/{}-{}.html", place + 1, plain);
}

std::string gap_text(const std::optional<double>& gap) {
  constexpr double rounding = 1e-6;  // what is left where every number is followed exactly
  if (!gap) return "–";
  return *gap < rounding ? "0: as many fitted numbers as data" : fmt::format("{:.3g}", *gap);
}

std::vector<report::TableCell> gap_cells(const Diagnosis& d) {
  return {report::text_cell(gap_text(d.gap.before)), report::text_cell(gap_text(d.gap.after)),
          report::text_cell(gap_text(d.gap.held_out_before)),
          report::text_cell(gap_text(d.gap.held_out_after))};
}

const std::vector<report::TableColumn> gap_columns = {
    {"gap before", "noise = 1", Kind::number, {}},
    {"gap after", "noise = 1", Kind::number, {}},
    {"unseen before", "noise = 1", Kind::number, {}},
    {"unseen after", "noise = 1", Kind::number, {}}};

constexpr auto gap_meaning =
    "Gap: mean squared distance in standard deviations of the noise (reduced whitened χ²). After: "
    "with what is named. Unseen: at a speed no fit saw.";

report::Table verdict_table(const std::string& title,
                            const std::vector<report::TableColumn>& first_columns) {
  report::Table table{.title = title, .caption = gap_meaning, .columns = first_columns, .rows = {}};
  table.columns.insert(table.columns.end(), gap_columns.begin(), gap_columns.end());
  return table;
}

report::TableCell linked(const std::string& text, const std::string& link) {
  report::TableCell cell = report::text_cell(text);
  cell.link = link;
  return cell;
}

}  // namespace

report::Table measured_verdicts(const std::vector<CoreStudy>& cores) {
  report::Table table = verdict_table("What is missing from the paper's model, by the measurement",
                                      {{"ball"}, {"the diagnosis names"}});
  for (std::size_t i = 0; i < cores.size(); ++i) {
    const Diagnosis& d = cores[i].diagnosis;
    table.rows.push_back({linked("core " + cores[i].label, page_file(i, "core-" + cores[i].label)),
                          report::text_cell(missing_in_words(d))});
    for (auto& cell : gap_cells(d)) table.rows.back().push_back(cell);
  }
  return table;
}

std::vector<report::Section> diagnosis_overview(const std::vector<CoreStudy>& cores,
                                                const std::vector<ExperimentStudy>& experiments) {
  std::vector<report::Section> sections;
  report::Section real{.title = "What is missing from the paper's model?", .blocks = {}};
  real.blocks.push_back(report::Paragraph{
      "The paper's model, one stiffness with damping by its own formula, is held against each "
      "core's measurement. The name of a core leads to its diagnosis: where the two part, what "
      "was tried, what is excluded, what to measure next."});
  for (const auto& core : cores) {
    const Diagnosis& d = core.diagnosis;
    std::string evidence =
        fmt::format("Gap {} before, {} after.", gap_text(d.gap.before), gap_text(d.gap.after));
    if (!d.next.empty()) evidence += " Measure next: " + d.next.front().what + ".";
    const bool decided =
        d.verdict == DiagnosisVerdict::agrees || d.verdict == DiagnosisVerdict::missing;
    report::Notice notice;
    notice.level = decided ? report::Notice::Level::finding : report::Notice::Level::abstention;
    notice.text = fmt::format("Core {}: {}", core.label, headline(d));
    notice.evidence = evidence;
    real.blocks.push_back(notice);
  }
  sections.push_back(std::move(real));
  if (experiments.empty()) return sections;

  report::Table table =
      verdict_table("Verdicts on synthetic experiments", {{"data"}, {"hidden"}, {"verdict"}});
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const auto& [label, hidden, d] = experiments[i];
    table.rows.push_back({linked(label, page_file(cores.size() + i, label)),
                          report::text_cell(hidden), report::text_cell(headline(d))});
    for (auto& cell : gap_cells(d)) table.rows.back().push_back(cell);
  }
  sections.push_back(
      {.title = "Does the diagnosis find what was hidden?",
       .blocks = {report::Paragraph{"A Hunt–Crossley model against data in which the effect is "
                                    "hidden; the diagnosis sees the data set alone. Each name "
                                    "leads to its diagnosis."},
                  table}});
  return sections;
}

std::vector<StudyPage> diagnosis_pages(const std::vector<CoreStudy>& cores,
                                       const std::vector<ExperimentStudy>& experiments,
                                       const Provenance& provenance) {
  std::vector<StudyPage> pages;
  for (std::size_t i = 0; i < cores.size(); ++i)
    pages.push_back({page_file(i, "core-" + cores[i].label),
                     diagnosis_report(cores[i].diagnosis, core_name(cores[i]), provenance,
                                      error_rates_on_page(cores[i].diagnosis))});
  for (std::size_t i = 0; i < experiments.size(); ++i)
    pages.push_back({page_file(cores.size() + i, experiments[i].label),
                     diagnosis_report(experiments[i].diagnosis, experiments[i].label, provenance,
                                      error_rates_on_page(experiments[i].diagnosis))});
  return pages;
}

}  // namespace rebound
