#include "comparisons/studies/reproduce/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/reproduce/table_rows.hpp"

namespace rebound {
namespace {

void append(std::vector<Finding>& findings, const std::vector<Finding>& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

/// SI unit of a row's numbers; "%" stays.
std::string si_unit(const std::string& unit) {
  if (unit == "ms") return "s";
  if (unit == "mm") return "m";
  if (unit == "km/h") return "m/s";
  const auto space = unit.find(' ');
  return space == std::string::npos ? unit : unit.substr(space + 1);
}

Json to_json(const Row& row) {
  return {{"table", row.key.table},
          {"core", row.key.core.empty() ? Json(nullptr) : Json(row.key.core)},
          {"speed_m_s", row.key.speed > 0.0 ? Json(row.key.speed) : Json(nullptr)},
          {"quantity", row.key.quantity},
          {"published", row.published.value},
          {"computed", row.computed},
          {"low", row.range.low},
          {"high", row.range.high},
          {"verdict", name_of(row.verdict)},
          {"half_width", row.published.half_width},
          {"unit", si_unit(row.key.unit)},
          {"printed", as_printed(row, row.published.value)},
          {"printed_unit", row.key.unit}};
}

Json to_json(const BlockSearch& search, const Repair& repair) {
  return {{"block", search.block},
          {"rows", search.rows},
          {"differing", search.differing},
          {"input", repair.input},
          {"change", repair.change == Change::common_value ? "common-value" : "common-factor"},
          {"low", repair.needed.low},
          {"high", repair.needed.high},
          {"repaired", repair.repaired},
          {"to_the_digit", repair.to_the_digit},
          {"complete", repair.repaired == search.rows}};
}

}  // namespace

std::size_t Reproduction::count(Verdict verdict) const {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const Row& row) { return row.verdict == verdict; }));
}

Reproduction reproduce(const std::filesystem::path& data_folder) {
  Reproduction result;
  result.paper = read_paper(data_folder);
  result.runs = run_published_model(result.paper);
  for (const auto& table : {table_2_rows(result.paper), table_3_rows(result.paper),
                            table_4_rows(result.paper), table_5_rows(result.paper)}) {
    for (const DerivedRow& row : table) result.rows.push_back(evaluate(row));
    const auto searches = search_table(table);
    result.searches.insert(result.searches.end(), searches.begin(), searches.end());
  }
  const auto claims = claim_rows(result.paper, result.runs);
  result.rows.insert(result.rows.end(), claims.begin(), claims.end());
  const Evidence evidence{result.paper, result.runs, result.rows, result.searches};
  append(result.findings, repair_findings(evidence));
  append(result.findings, summary_findings(evidence));
  append(result.findings, damping_findings(evidence));
  append(result.findings, stiffness_findings(evidence));
  append(result.findings, trend_findings(evidence));
  return result;
}

Json to_json(const Reproduction& reproduction) {
  Json rows = Json::array(), findings = Json::array(), repairs = Json::array();
  for (const Row& row : reproduction.rows) rows.push_back(to_json(row));
  for (const Finding& finding : reproduction.findings)
    findings.push_back(
        {{"id", finding.id}, {"statement", finding.statement}, {"evidence", finding.evidence}});
  for (const BlockSearch& search : reproduction.searches) {
    for (const Repair& repair : search.repairs) repairs.push_back(to_json(search, repair));
    if (search.repairs.empty()) repairs.push_back(to_json(search, search.nearest));
  }
  Json counts;
  for (const Verdict verdict : {Verdict::reproduces, Verdict::within_rounding, Verdict::differs})
    counts[name_of(verdict)] = reproduction.count(verdict);
  return {{"schema", 1},
          {"rows", rows},
          {"findings", findings},
          {"counts", counts},
          {"repairs", repairs}};
}

std::vector<Row> differences_first(const std::vector<Row>& rows) {
  std::vector<Row> sorted = rows;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Row& one, const Row& other) {
    return static_cast<int>(one.verdict) > static_cast<int>(other.verdict);
  });
  return sorted;
}

std::string to_text(const Reproduction& reproduction) {
  std::string text = fmt::format(
      "{} published numbers: {} reproduce, {} within rounding, {} differ\n\n",
      reproduction.rows.size(), reproduction.count(Verdict::reproduces),
      reproduction.count(Verdict::within_rounding), reproduction.count(Verdict::differs));
  text += fmt::format("{:<16}{:<12}{:<17}{:<54}{:>9}{:>11}  {:<20}{}\n", "verdict", "where", "of",
                      "quantity", "printed", "computed", "rounding allows", "unit");
  for (const Row& row : differences_first(reproduction.rows)) {
    const std::string range = fmt::format("{} .. {}", as_printed(row, row.range.low, 1),
                                          as_printed(row, row.range.high, 1));
    text += fmt::format("{:<16}{:<12}{:<17}{:<54}{:>9}{:>11}  {:<20}{}\n", name_of(row.verdict),
                        row.key.table, scope_of(row.key.core, row.key.speed), row.key.quantity,
                        as_printed(row, row.published.value), as_printed(row, row.computed, 1),
                        range, row.key.unit == "1" ? "-" : row.key.unit);
  }
  text += fmt::format("\nFindings ({})\n", reproduction.findings.size());
  for (const Finding& finding : reproduction.findings)
    text += fmt::format("\n{}\n  {}\n  {}\n", finding.id, finding.statement, finding.evidence);
  return text;
}

}  // namespace rebound
