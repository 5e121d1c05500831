#include "comparisons/accuracy/tier_comparison/comparison_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "comparisons/io/results/key_words.hpp"
#include "comparisons/models/parallel/processor_time.hpp"

namespace rebound {
namespace {

using report::Origin;
using Kind = report::TableColumn::Kind;
using Verdict = report::TableCell::Verdict;

bool all_pass(const std::vector<CaseComparison>& cases) {
  return std::all_of(cases.begin(), cases.end(),
                     [](const CaseComparison& one) { return one.passes(); });
}

bool any_baseline(const std::vector<CaseComparison>& cases) {
  return std::any_of(cases.begin(), cases.end(),
                     [](const CaseComparison& one) { return !one.movements.empty(); });
}

Json movement_json(const Movement& one) {
  return {{"tier", one.tier},        {"speed_m_s", one.speed},
          {"key", one.key},          {"before", one.before},
          {"now", one.now},          {"tolerance", one.tolerance},
          {"bars", one.bars()},      {"measured_by", name_of(one.measured_by)},
          {"moved", one.has_moved()}};
}

Json gap_json(const TierGap& one) {
  return {{"speed_m_s", one.speed},
          {"key", one.key},
          {"lumped", one.lumped},
          {"fem", one.fem},
          {"tolerance", one.tolerance},
          {"bars", one.bars()},
          {"allowed_share", number_or_null(one.allowed_share)},
          {"fails", one.fails()}};
}

/// Three digits, whole numbers from there on, as they are said: "+3.82", "-6080".
std::string bars_text(double bars) {
  return std::abs(bars) < 1000.0 ? fmt::format("{:+.3g}", bars) : fmt::format("{:+.0f}", bars);
}

std::string movement_text(const Movement& one) {
  return fmt::format("{} has moved: {} at {:g} m/s from {:.6g} to {:.6g}, {} bars of {}", one.tier,
                     one.key, one.speed, one.before, one.now, bars_text(one.bars()),
                     name_of(one.measured_by));
}

std::string gap_text(const TierGap& one) {
  return fmt::format("{:<20} at {:g} m/s: lumped {:.5g}, FE {:.5g} +- {:.2g}, {:+.2f} %, {} bars{}",
                     one.key, one.speed, one.lumped, one.fem, one.tolerance,
                     100.0 * (one.lumped / one.fem - 1.0), bars_text(one.bars()),
                     one.fails()         ? "  BEYOND what is allowed"
                     : one.allowed_share ? "  within what is allowed"
                                         : "");
}

/// The largest gap between the tiers, as a share of FE, in words.
std::string largest_gap(const std::vector<CaseComparison>& cases) {
  double most = -1.0;
  std::string words = "There is one tier and no baseline: nothing is compared.";
  for (const CaseComparison& one : cases)
    for (const TierGap& gap : one.gaps) {
      const double share = std::abs(gap.lumped / gap.fem - 1.0);
      if (!(share > most)) continue;
      most = share;
      words = fmt::format("The tiers differ by {:.3g} % at most: {} of {} at {:g} m/s, {} bars.",
                          100.0 * share, gap.key, one.name, gap.speed, bars_text(gap.bars()));
    }
  return words;
}

std::string headline_of(const std::vector<CaseComparison>& cases) {
  std::vector<std::string> failed;
  for (const CaseComparison& one : cases)
    if (!one.passes()) failed.push_back(one.name);
  if (failed.empty())
    return any_baseline(cases) ? "No tier has moved beyond what its numerical error leaves open."
                               : largest_gap(cases);
  return fmt::format("{} of {} cases differ by more than numerical error allows: {}.",
                     failed.size(), cases.size(), fmt::join(failed, ", "));
}

/// A number of a scalar, with the unit that its key names.
report::TableCell with_unit(double value, int digits, const std::string& key) {
  return report::text_cell(
      fmt::format("{:.{}g}{}", value, digits, behind_number(words_of_key(key).unit)));
}

report::Table movement_table(const CaseComparison& one) {
  report::Table table{.title = "Against the baseline",
                      .caption =
                          "A bar is what both runs may differ by, by the error that "
                          "they do not share: rounding on the same mesh and step, the "
                          "step's share on the same mesh, else the whole numerical error.",
                      .columns = {{"tier"},
                                  {"speed", "m/s", Kind::number},
                                  {"scalar"},
                                  {"before", "", Kind::text, Origin::predicted},
                                  {"now", "", Kind::text, Origin::predicted},
                                  {"change", "bars", Kind::number, Origin::derived},
                                  {"measured by"}},
                      .rows = {}};
  for (const Movement& m : one.movements)
    table.rows.push_back(
        {report::text_cell(m.tier), report::number_cell(m.speed, 4),
         report::text_cell(words_of_key(m.key).quantity), with_unit(m.before, 6, m.key),
         with_unit(m.now, 6, m.key),
         report::text_cell(bars_text(m.bars()), m.has_moved() ? Verdict::bad : Verdict::good),
         report::text_cell(name_of(m.measured_by))});
  return table;
}

report::Table gap_table(const CaseComparison& one) {
  report::Table table{
      .title = "Tier against tier",
      .caption =
          "A bar is both numerical errors together. A gap of many bars is one of the models, "
          "not of the numbers.",
      .columns = {{"speed", "m/s", Kind::number},
                  {"scalar"},
                  {"lumped", "", Kind::text, Origin::predicted},
                  {"FE", "", Kind::text, Origin::predicted},
                  {"gap", "%", Kind::number, Origin::derived},
                  {"gap", "bars", Kind::number, Origin::derived},
                  {"allowed", "%", Kind::number}},
      .rows = {}};
  for (const TierGap& gap : one.gaps)
    table.rows.push_back(
        {report::number_cell(gap.speed, 4), report::text_cell(words_of_key(gap.key).quantity),
         with_unit(gap.lumped, 5, gap.key), with_unit(gap.fem, 5, gap.key),
         report::text_cell(fmt::format("{:+.2f}", 100.0 * (gap.lumped / gap.fem - 1.0)),
                           gap.fails()         ? Verdict::bad
                           : gap.allowed_share ? Verdict::good
                                               : Verdict::none),
         report::text_cell(bars_text(gap.bars())),
         report::text_cell(gap.allowed_share ? fmt::format("{:g}", 100.0 * *gap.allowed_share)
                                             : "not judged")});
  return table;
}

/// Both tiers over the speed, each with its numerical error.
report::Figure scalar_figure(const CaseComparison& one, const std::string& key,
                             const report::Axis& axis, double scale) {
  report::Figure figure{.title = axis.quantity + " over speed",
                        .caption = "Bars are numerical errors.",
                        .x = {"approach speed", "m/s"},
                        .y = axis};
  for (const char* tier : {"lumped", "fem"}) {
    report::Series series;
    series.name = std::string(tier) == "fem" ? "FE" : tier;
    series.style = report::Series::Style::points;
    for (const TierRecord& record : one.records)
      if (record.tier == tier) {
        const RecordedScalar& scalar = record.scalars.at(key);
        series.x.push_back(record.speed);
        series.y.push_back(scale * scalar.value);
        series.y_error.push_back(scale * scalar.numerical);
      }
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  }
  return figure;
}

}  // namespace

Json to_json(const std::vector<CaseComparison>& cases) {
  Json list = Json::array();
  for (const CaseComparison& one : cases) {
    Json records = Json::array(), movements = Json::array(), gaps = Json::array();
    for (const TierRecord& record : one.records) records.push_back(to_json(record));
    for (const Movement& movement : one.movements) movements.push_back(movement_json(movement));
    for (const TierGap& gap : one.gaps) gaps.push_back(gap_json(gap));
    list.push_back({{"name", one.name},
                    {"passes", one.passes()},
                    {"moved_tiers", one.moved_tiers()},
                    {"records", records},
                    {"movements", movements},
                    {"gaps", gaps},
                    {"remarks", one.remarks}});
  }
  double fem_seconds = 0.0;
  for (const CaseComparison& one : cases)
    for (const TierRecord& record : one.records) fem_seconds += record.fem_seconds;
  return {{"schema", 1},
          {"passes", all_pass(cases)},
          {"cases", list},
          {"fem_processor_s", fem_seconds},
          {"processor_s", process_time()}};
}

std::string to_text(const std::vector<CaseComparison>& cases) {
  std::string text;
  for (const CaseComparison& one : cases) {
    text += fmt::format("{}: {}\n", one.name, one.passes() ? "passes" : "FAILS");
    for (const std::string& remark : one.remarks) text += "  " + remark + "\n";
    for (const Movement& movement : one.movements)
      if (movement.has_moved()) text += "  " + movement_text(movement) + "\n";
    for (const TierGap& gap : one.gaps) text += "  " + gap_text(gap) + "\n";
  }
  return text + headline_of(cases) + "\n";
}

report::Report comparison_report(const std::vector<CaseComparison>& cases) {
  report::Report page{
      .title = "Comparison of the tiers",
      .subtitle = fmt::format("{} case{}", cases.size(), cases.size() == 1 ? "" : "s"),
      .headline = headline_of(cases),
      .notices = {},
      .sections = {}};
  for (const CaseComparison& one : cases) {
    report::Section section{.title = "Case " + one.name, .blocks = {}};
    for (const Movement& movement : one.movements)
      if (movement.has_moved())
        section.blocks.emplace_back(
            report::Notice{report::Notice::Level::failure, movement_text(movement) + "."});
    for (const std::string& remark : one.remarks)
      section.blocks.emplace_back(report::Notice{report::Notice::Level::warning, remark + "."});
    if (!one.movements.empty()) section.blocks.emplace_back(movement_table(one));
    if (!one.gaps.empty()) section.blocks.emplace_back(gap_table(one));
    section.blocks.emplace_back(scalar_figure(one, "restitution", {"restitution", "1"}, 1.0));
    section.blocks.emplace_back(
        scalar_figure(one, "contact_time_s", {"contact time", "ms"}, report::milli));
    section.blocks.emplace_back(scalar_figure(one, "peak_force_N", {"peak force", "N"}, 1.0));
    page.sections.push_back(std::move(section));
  }
  return page;
}

}  // namespace rebound
