#include "comparisons/discrepancy/trials/trial_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/trials/trial_controls.hpp"
#include "comparisons/discrepancy/trials/trial_pictures.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"

namespace rebound {
namespace {

using report::text_cell;

report::TableCell met_cell(const TrialGate& gate) {
  using Verdict = report::TableCell::Verdict;
  switch (gate.answer()) {
    case GateAnswer::not_asked: return text_cell("–");
    case GateAnswer::no_trial: return text_cell("no such trial", Verdict::doubtful);
    case GateAnswer::too_few: return text_cell("too few trials", Verdict::doubtful);
    case GateAnswer::met: return text_cell("yes", Verdict::good);
    case GateAnswer::missed: return text_cell("no", Verdict::bad);
  }
  return text_cell("–");
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
  return fmt::format("{:.0f}\u00a0% ({}\u00a0of\u00a0{})", share.percent(), share.count, share.of);
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

/// The same with the interval, for tables of many columns.
report::TableCell interval_cell(const Share& share) {
  if (share.of == 0) return text_cell("–");
  return text_cell(fmt::format("{}\u00a0of\u00a0{} [{:.0f},\u00a0{:.0f}]\u00a0%", share.count,
                               share.of, share.percent_low(), share.percent_high()));
}

report::Table share_table(const std::string& title, const std::string& caption,
                          const std::string& heading, const std::map<std::string, Share>& shares) {
  report::Table table{
      .title = title, .caption = caption, .columns = {{heading}, {"share"}}, .rows = {}};
  for (const auto& [name, share] : shares)
    table.rows.push_back({text_cell(name), text_cell(share_text(share))});
  return table;
}

report::Table rate_table(const RateTable& rates) {
  const bool has_unit = !rates.unit.empty() && rates.unit != "1";
  const bool has_nulls = std::any_of(rates.rows.begin(), rates.rows.end(),
                                     [](const RateRow& row) { return row.false_alarm.of > 0; });
  report::Table table{.title = "By " + rates.what,
                      .caption =
                          "Single effects of a family, with 95 % Wilson intervals. At best: "
                          "the chance to tell the family for a choice between the hidden "
                          "form and the most similar one of another family, both known.",
                      .columns = {{has_unit ? rates.what + " / " + rates.unit : rates.what},
                                  {"gap said"},
                                  {"family right"},
                                  {"at best"},
                                  {"name right or in the set"},
                                  {"wrong name"}},
                      .rows = {}};
  if (has_nulls) table.columns.push_back({"false alarms on nulls"});
  for (const RateRow& row : rates.rows) {
    table.rows.push_back(
        {text_cell(row.label), interval_cell(row.detected), interval_cell(row.family_right),
         text_cell(row.family_at_best ? fmt::format("{:.0f} %", 100.0 * *row.family_at_best) : "-"),
         interval_cell(row.name_right), interval_cell(row.wrong_name)});
    if (has_nulls) table.rows.back().push_back(interval_cell(row.false_alarm));
  }
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

/// What was asked, and for balls in finite elements false alarms by what they are made of.
report::Section score_section(const std::string& title, const TrialScores& scores) {
  report::Section section{.title = title, .blocks = {gate_table(scores)}};
  if (!scores.false_alarms_by_ball.empty())
    section.blocks.push_back(share_table("By material", "Nulls for which a gap was said.",
                                         "what the ball is made of", scores.false_alarms_by_ball));
  return section;
}

/// Balls in finite elements, beside those of a law.
report::Section fem_section(const std::string& title, const TrialScores& scores) {
  report::Section section = score_section(title, scores);
  if (!scores.confusion.empty())
    section.blocks.push_back(confusion_matrix(scores.confusion, "By family, in finite elements",
                                              "hidden family", "what was said"));
  return section;
}

constexpr auto believed_title = "Balls in finite elements, and finite elements believed";

/// A page without balls that obey a law.
report::Report fem_report(const TrialScores& scores) {
  const std::string title = "Blind trials of the diagnosis: balls in finite elements";
  if (!scores.in_fem) {
    report::Report page = trial_report(*scores.fem_believed);
    page.title = title + ", and finite elements believed";
    return page;
  }
  report::Report page = trial_report(*scores.in_fem);
  page.title = title;
  if (scores.fem_believed)
    page.sections.insert(page.sections.begin() + 1,
                         fem_section(believed_title, *scores.fem_believed));
  return page;
}

std::string subtitle_of(const TrialScores& scores) {
  std::string origins;
  for (const auto& [origin, count] : scores.origins)
    origins += fmt::format("{}{} of {}", origins.empty() ? "" : "; ", count, origin);
  return fmt::format("{} data sets whose contents were sealed before the first was diagnosed: {}",
                     scores.trials, origins);
}

std::string headline_of(const TrialScores& scores) {
  const auto gates_with = [&](GateAnswer answer) {
    return std::count_if(scores.gates.begin(), scores.gates.end(),
                         [&](const TrialGate& gate) { return gate.answer() == answer; });
  };
  const auto met = gates_with(GateAnswer::met), missed = gates_with(GateAnswer::missed),
             without = gates_with(GateAnswer::no_trial), few = gates_with(GateAnswer::too_few);
  std::string text = fmt::format("{} of {} gates are met", met, met + missed);
  if (without > 0)
    text += fmt::format("; for {} there {} no trial", without, without == 1 ? "is" : "are");
  if (few > 0) text += fmt::format("; for {} there are too few trials", few);
  return text + ".";
}

}  // namespace

report::Report trial_report(const TrialScores& scores) {
  if (scores.trials == 0 && (scores.in_fem || scores.fem_believed)) return fem_report(scores);
  report::Report page{.title = "Blind trials of the diagnosis",
                      .subtitle = subtitle_of(scores),
                      .headline = headline_of(scores),
                      .notices = {},
                      .sections = {}};
  if (scores.protocols.size() > 1)
    page.notices.push_back({report::Notice::Level::warning,
                            fmt::format("Outcomes of {} protocols were taken together: these are "
                                        "not one error rate.",
                                        scores.protocols.size())});
  page.sections.push_back(score_section("Scores", scores));
  if (scores.in_fem)
    page.sections.push_back(fem_section("Balls in finite elements", *scores.in_fem));
  if (scores.fem_believed)
    page.sections.push_back(fem_section(believed_title, *scores.fem_believed));
  report::Section power{.title = "Power", .blocks = {}};
  for (const RateTable& rates : scores.rates)
    if (rates.by == "visible_chi_square" && !rates.rows.empty()) {
      for (report::Figure& figure : power_figures(rates)) power.blocks.push_back(std::move(figure));
      power.blocks.push_back(rate_table(rates));
    }
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
    if (!rates.rows.empty() && rates.by != "visible_chi_square")
      details.blocks.push_back(rate_table(rates));
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
