#include "comparisons/discrepancy/trials/trial_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/trial_controls.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"

namespace rebound {
namespace {

using report::Origin;
using report::Series;
using report::text_cell;

constexpr double percent = 100.0;

report::TableCell met_cell(const TrialGate& gate) {
  using Verdict = report::TableCell::Verdict;
  if (!gate.is_asked()) return text_cell("–");
  if (gate.share.of == 0) return text_cell("no such trial", Verdict::doubtful);
  return gate.passes() ? text_cell("yes", Verdict::good) : text_cell("no", Verdict::bad);
}

report::Table gate_table(const TrialScores& scores) {
  report::Table table{.title = "What was asked and what came out",
                      .caption =
                          "Shares with their 95 % Wilson intervals. Effects count where they "
                          "show: χ² of 25 or more against the refitted model without them.",
                      .columns = {{"quantity"}, {"share"}, {"asked"}, {"met"}},
                      .rows = {}};
  for (const TrialGate& gate : scores.gates)
    table.rows.push_back({text_cell(gate.what), text_cell(share_text(gate.share)),
                          text_cell(gate.is_asked() ? asked_text(gate) : "–"), met_cell(gate)});
  return table;
}

/// Without a place where a line may break.
std::string share_or_dash(const Share& share) {
  if (share.of == 0) return "–";
  return fmt::format("{:.0f}\u00a0% ({}\u00a0of\u00a0{})", percent * share.value(), share.count,
                     share.of);
}

report::Table control_table(const TrialScores& scores) {
  report::Table table{
      .title = "The diagnosis beside simpler methods",
      .caption =
          "The same trials by the same rules. Lowest BIC: of all sets that the diagnosis fitted "
          "the one with the lowest information criterion, the believed model among them. Sparse "
          "regression: the residual force regressed on terms of deflection and rate; it says "
          "families, no names, and has no term for memory or for another mass. Random: nothing or "
          "one of the families, and an effect of it.",
      .columns = {{"quantity"}, {"asked"}, {"diagnosis"}},
      .rows = {}};
  for (const ControlName& control : control_names) table.columns.push_back({control.words});
  for (std::size_t i = 0; i < scores.gates.size(); ++i) {
    const TrialGate& gate = scores.gates[i];
    std::vector<report::TableCell> row{text_cell(gate.what),
                                       text_cell(gate.is_asked() ? asked_text(gate) : "–"),
                                       text_cell(share_or_dash(gate.share))};
    for (const ControlName& control : control_names)
      row.push_back(text_cell(share_or_dash(scores.controls.at(control.key)[i].share)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Table share_table(const std::string& title, const std::string& caption,
                          const std::string& heading, const std::map<std::string, Share>& shares) {
  report::Table table{
      .title = title, .caption = caption, .columns = {{heading}, {"share"}}, .rows = {}};
  for (const auto& [name, share] : shares)
    table.rows.push_back({text_cell(name), text_cell(share_text(share))});
  return table;
}

report::Matrix confusion_matrix(const ConfusionMatrix& confusion, const std::string& title,
                                const std::string& row_heading, const std::string& group) {
  report::Matrix matrix{.title = title,
                        .caption =
                            "Colour: share of the trials of a row. Number: how many they are. "
                            "Effects that do not show are left out.",
                        .quantity = "share of the row",
                        .unit = "1",
                        .row_heading = row_heading,
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::sequential, 1.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  const auto columns = columns_of(confusion);
  for (const std::string& column : columns) matrix.columns.push_back({group, column});
  for (const auto& [name, cells] : confusion) {
    int total = 0;
    for (const auto& [column, count] : cells) total += count;
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    report::MatrixRow row{fmt::format("{} ({})", words, total), {}};
    for (const std::string& column : columns) {
      const auto found = cells.find(column);
      const int count = found == cells.end() ? 0 : found->second;
      row.cells.push_back({.value = static_cast<double>(count) / total,
                           .text = count == 0 ? "–" : fmt::format("{}", count)});
    }
    matrix.rows.push_back(std::move(row));
  }
  return matrix;
}

Series rate_series(const std::string& name, const RateTable& table, Share RateRow::*share) {
  Series series{.name = name,
                .origin = Origin::derived,
                .x = {},
                .y = {},
                .x_error = {},
                .y_error = {},
                .y_low = {},
                .y_high = {}};
  for (const RateRow& row : table.rows) {
    const Share& one = row.*share;
    if (one.of == 0 || row.high <= 0.0) continue;
    constexpr double smallest_shown = 10.0;  // a logarithmic axis has no zero
    series.x.push_back(std::sqrt(std::max(row.low, smallest_shown) * row.high));
    series.y.push_back(percent * one.value());
    series.y_low.push_back(percent * std::min(one.low(), one.value()));
    series.y_high.push_back(percent * std::max(one.high(), one.value()));
  }
  return series;
}

/// Power over the size of the effect, one picture a question: bands would cover each other.
void add_power(const RateTable& table, report::Section& section) {
  const std::pair<const char*, Share RateRow::*> questions[] = {
      {"a gap is said", &RateRow::detected},
      {"the family is right", &RateRow::family_right},
      {"the name is right or in the set", &RateRow::name_right}};
  for (const auto& [words, share] : questions) {
    report::Figure figure{
        .title = fmt::format("Power: {}", words),
        .caption =
            "Single effects of a family, by how plainly they show. Each point is a bin; "
            "the band is its 95 % Wilson interval. Left of 25 an effect does not count.",
        .x = {"visible χ² of the hidden effect", "1", report::Axis::Spacing::logarithmic},
        .y = {"share of the trials", "%"},
        .series = {}};
    Series series = rate_series(words, table, share);
    if (series.x.empty()) continue;
    figure.series.push_back(std::move(series));
    section.blocks.push_back(std::move(figure));
  }
}

report::Table rate_table(const RateTable& rates) {
  const bool has_unit = !rates.unit.empty() && rates.unit != "1";
  report::Table table{.title = "By " + rates.what,
                      .caption =
                          "Single effects of a family; false alarms are those of the nulls. Shares "
                          "with their 95 % Wilson intervals.",
                      .columns = {{has_unit ? rates.what + " / " + rates.unit : rates.what},
                                  {"gap said"},
                                  {"family right"},
                                  {"name right or in the set"},
                                  {"wrong name"},
                                  {"false alarms"}},
                      .rows = {}};
  for (const RateRow& row : rates.rows)
    table.rows.push_back(
        {text_cell(row.label), text_cell(share_text(row.detected)),
         text_cell(share_text(row.family_right)), text_cell(share_text(row.name_right)),
         text_cell(share_text(row.wrong_name)), text_cell(share_text(row.false_alarm))});
  return table;
}

report::Section protocol_section(const TrialScores& scores) {
  report::Section section{.title = "What the outcomes were made with",
                          .folding = report::Section::Folding::folded,
                          .blocks = {}};
  for (const auto& [digest, protocol] : scores.protocols)
    section.blocks.push_back(report::Verbatim{"Protocol " + digest, dump(protocol)});
  return section;
}

std::string subtitle_of(const TrialScores& scores) {
  std::string origins;
  for (const auto& [origin, count] : scores.origins)
    origins += fmt::format("{}{} of {}", origins.empty() ? "" : "; ", count, origin);
  return fmt::format("{} data sets whose contents were sealed before the first was diagnosed: {}",
                     scores.trials, origins);
}

}  // namespace

report::Report trial_report(const TrialScores& scores) {
  const auto met = std::count_if(scores.gates.begin(), scores.gates.end(),
                                 [](const auto& gate) { return gate.is_asked() && gate.passes(); });
  const auto asked = std::count_if(scores.gates.begin(), scores.gates.end(),
                                   [](const auto& gate) { return gate.is_asked(); });
  report::Report page{.title = "Blind trials of the diagnosis",
                      .subtitle = subtitle_of(scores),
                      .headline = fmt::format("{} of {} gates are met.", met, asked),
                      .notices = {},
                      .sections = {}};
  if (scores.protocols.size() > 1)
    page.notices.push_back({report::Notice::Level::warning,
                            fmt::format("Outcomes of {} protocols were taken together: these are "
                                        "not one error rate.",
                                        scores.protocols.size())});
  page.sections.push_back({.title = "Scores", .blocks = {gate_table(scores)}});
  report::Section power{.title = "Power", .blocks = {}};
  for (const RateTable& rates : scores.rates)
    if (rates.by == "visible_chi_square") add_power(rates, power);
  if (!power.blocks.empty()) page.sections.push_back(std::move(power));
  report::Section confusion{.title = "What was hidden, and what was said", .blocks = {}};
  if (!scores.confusion.empty())
    confusion.blocks.push_back(
        confusion_matrix(scores.confusion, "By family", "hidden family", "what was said"));
  if (!scores.confusion_by_name.empty())
    confusion.blocks.push_back(confusion_matrix(scores.confusion_by_name, "By name",
                                                "nearest effect of the list",
                                                "the name that was said, or the verdict"));
  if (!confusion.blocks.empty()) page.sections.push_back(std::move(confusion));
  page.sections.push_back({.title = "Controls", .blocks = {control_table(scores)}});
  report::Section details{
      .title = "In detail", .folding = report::Section::Folding::folded, .blocks = {}};
  for (const RateTable& rates : scores.rates)
    if (!rates.rows.empty()) details.blocks.push_back(rate_table(rates));
  details.blocks.push_back(share_table("False alarms by noise", "Nulls for which a gap was said.",
                                       "noise", scores.false_alarms_by_noise));
  details.blocks.push_back(
      share_table("By form", "Family right, or left open with the family among the candidates.",
                  "family and form", scores.not_wrong_by_form));
  page.sections.push_back(std::move(details));
  page.sections.push_back(protocol_section(scores));
  return page;
}

}  // namespace rebound
