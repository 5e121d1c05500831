#include "comparisons/accuracy/verification/verification_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rebound {
namespace {

const char* name_of(ToleranceScale scale) {
  switch (scale) {
    case ToleranceScale::relative: return "relative";
    case ToleranceScale::absolute: return "absolute";
    case ToleranceScale::upper_bound: return "upper_bound";
  }
  return "";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string target_text(const VerificationRow& row) {
  return fmt::format("{}{:.7g}", row.scale == ToleranceScale::upper_bound ? "<= " : "", row.target);
}

}  // namespace

Json to_json(const VerificationTable& table) {
  Json json = {{"schema", 1}, {"passed", all_pass(table)}, {"rows", Json::array()}};
  for (const VerificationRow& row : table)
    json["rows"].push_back({{"case", row.case_id},
                            {"quantity", row.quantity},
                            {"unit", row.unit},
                            {"target", row.target},
                            {"result", row.result},
                            {"deviation", row.deviation()},
                            {"tolerance", row.tolerance},
                            {"tolerance_scale", name_of(row.scale)},
                            {"order", number_or_null(row.order)},
                            {"passed", row.passes()},
                            {"source", row.source}});
  return json;
}

std::string to_csv(const VerificationTable& table) {
  std::string text =
      "case,quantity,unit,target,result,deviation,tolerance,tolerance_scale,order,passed,source\n";
  for (const VerificationRow& row : table)
    text += fmt::format("{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{},{}\n",
                        quoted(row.case_id), quoted(row.quantity), quoted(row.unit), row.target,
                        row.result, row.deviation(), row.tolerance, name_of(row.scale),
                        row.order ? fmt::format("{:.17g}", *row.order) : "", row.passes(),
                        quoted(row.source));
  return text;
}

std::string to_text(const VerificationTable& table) {
  std::size_t widest = 8;
  for (const VerificationRow& row : table) widest = std::max(widest, row.quantity.size());
  std::string text =
      fmt::format("{:<12}{:<{}}{:>14}{:>14}  {:<6}{:>11}{:>11}{:>7}\n", "case", "quantity",
                  widest + 1, "target", "result", "", "deviation", "tolerance", "order");
  for (const VerificationRow& row : table)
    text += fmt::format(
        "{:<12}{:<{}}{:>14}{:>14.7g}  {:<6}{:>11.2e}{:>11.2e}{:>7}{}\n", row.case_id, row.quantity,
        widest + 1, target_text(row), row.result, row.unit, row.deviation(), row.tolerance,
        row.order ? fmt::format("{:.2f}", *row.order) : "-", row.passes() ? "" : "  FAILS");
  const auto passed =
      std::count_if(table.begin(), table.end(), [](const auto& row) { return row.passes(); });
  text +=
      fmt::format("{} of {} pass; deviation in the scale of the tolerance\n", passed, table.size());
  return text;
}

}  // namespace rebound
