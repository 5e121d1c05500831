#include "comparisons/discrepancy/trials/trial_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rebound {
namespace {

using report::number_cell;
using report::text_cell;
using Column = report::TableColumn;

std::string share_text(const Share& share) {
  if (share.of == 0) return "none";
  return fmt::format("{} of {} = {:.1f} % [{:.1f}, {:.1f}]", share.count, share.of,
                     100.0 * share.value(), 100.0 * share.low(), 100.0 * share.high());
}

std::string asked_text(const TrialGate& gate) {
  std::string text;
  if (gate.least > 0.0) text += fmt::format("at least {:.0f} %", 100.0 * gate.least);
  if (gate.most < 1.0)
    text += fmt::format("{}at most {:.0f} %", text.empty() ? "" : ", ", 100.0 * gate.most);
  if (gate.most_of_upper_bound < 1.0)
    text += fmt::format(", upper bound {:.1f} %", 100.0 * gate.most_of_upper_bound);
  return gate.is_asked() ? text : "-";
}

Json share_json(const Share& share) {
  return {{"count", share.count},
          {"of", share.of},
          {"share", share.of == 0 ? Json(nullptr) : Json(share.value())},
          {"interval", {share.low(), share.high()}}};
}

Json shares_json(const std::map<std::string, Share>& shares) {
  Json json = Json::object();
  for (const auto& [name, share] : shares) json[name] = share_json(share);
  return json;
}

std::set<std::string> columns_of(const TrialScores& scores) {
  std::set<std::string> columns;
  for (const auto& [row, cells] : scores.confusion)
    for (const auto& [column, count] : cells) columns.insert(column);
  return columns;
}

report::Table gate_table(const TrialScores& scores) {
  using Verdict = report::TableCell::Verdict;
  report::Table table{.title = "What was asked and what came out",
                      .caption =
                          "Shares with their 95 % Wilson intervals. Effects count where they "
                          "show: χ² of 25 or more against the refitted model without them.",
                      .columns = {{"quantity"}, {"share"}, {"asked"}, {"met"}},
                      .rows = {}};
  for (const TrialGate& gate : scores.gates) {
    table.rows.push_back(
        {text_cell(gate.what), text_cell(share_text(gate.share)), text_cell(asked_text(gate)),
         gate.is_asked()
             ? text_cell(gate.passes() ? "yes" : "no", gate.passes() ? Verdict::good : Verdict::bad)
             : text_cell("-")});
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

report::Matrix confusion_matrix(const TrialScores& scores) {
  report::Matrix matrix{.title = "What was hidden, and what was said of it",
                        .caption =
                            "Share of the trials of a row; the number in the cell counts "
                            "them.",
                        .quantity = "share of the row",
                        .unit = "1",
                        .row_heading = "hidden",
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::sequential, 1.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  const auto columns = columns_of(scores);
  for (const std::string& column : columns) matrix.columns.push_back({"", column});
  for (const auto& [name, cells] : scores.confusion) {
    int total = 0;
    for (const auto& [column, count] : cells) total += count;
    report::MatrixRow row{name, {}};
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

}  // namespace

Json to_json(const TrialScores& scores) {
  Json gates = Json::array();
  for (const TrialGate& gate : scores.gates) {
    Json one = share_json(gate.share);
    one["what"] = gate.what;
    one["asked"] = asked_text(gate);
    one["met"] = gate.is_asked() ? Json(gate.passes()) : Json(nullptr);
    gates.push_back(std::move(one));
  }
  return {{"schema", 1},
          {"trials", scores.trials},
          {"gates", gates},
          {"confusion", scores.confusion},
          {"false_alarms_by_noise", shares_json(scores.false_alarms_by_noise)},
          {"not_wrong_by_form", shares_json(scores.not_wrong_by_form)},
          {"seconds", {{"median", scores.median_seconds}, {"longest", scores.longest_seconds}}}};
}

std::string to_text(const TrialScores& scores) {
  std::string text = fmt::format("{} trials; a diagnosis took {:.2g} s, at most {:.2g} s\n",
                                 scores.trials, scores.median_seconds, scores.longest_seconds);
  for (const TrialGate& gate : scores.gates) {
    text += fmt::format("{:<52}{:<36}{}{}\n", gate.what, share_text(gate.share), asked_text(gate),
                        !gate.is_asked() ? "" : (gate.passes() ? "  met" : "  NOT MET"));
  }
  text += "\nhidden: what was said\n";
  for (const auto& [row, cells] : scores.confusion) {
    text += fmt::format("  {:<16}", row);
    for (const auto& [column, count] : cells) text += fmt::format("{} {}  ", column, count);
    text += "\n";
  }
  return text;
}

report::Report trial_report(const TrialScores& scores) {
  const auto met = std::count_if(scores.gates.begin(), scores.gates.end(),
                                 [](const auto& gate) { return gate.is_asked() && gate.passes(); });
  const auto asked = std::count_if(scores.gates.begin(), scores.gates.end(),
                                   [](const auto& gate) { return gate.is_asked(); });
  report::Report page{.title = "Blind trials of the diagnosis",
                      .subtitle = fmt::format("{} data sets whose contents were sealed before the "
                                              "first was diagnosed",
                                              scores.trials),
                      .headline = fmt::format("{} of {} gates are met.", met, asked),
                      .notices = {},
                      .sections = {}};
  page.sections.push_back(
      {.title = "Scores", .blocks = {gate_table(scores), confusion_matrix(scores)}});
  page.sections.push_back(
      {.title = "In detail",
       .blocks = {share_table("False alarms by noise", "Nulls for which a gap was said.", "noise",
                              scores.false_alarms_by_noise),
                  share_table("By form",
                              "Family right, or left open with the family among the candidates.",
                              "family and form", scores.not_wrong_by_form)}});
  return page;
}

}  // namespace rebound
