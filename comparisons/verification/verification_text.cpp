#include "comparisons/verification/verification_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rebound {

Json to_json(const VerificationTable& table) {
  Json json = {{"schema", 1}, {"passed", all_pass(table)}, {"rows", Json::array()}};
  for (const VerificationRow& row : table)
    json["rows"].push_back(
        {{"rung", row.rung},
         {"quantity", row.quantity},
         {"unit", row.unit},
         {"target", row.target},
         {"result", row.result},
         {"deviation", row.deviation()},
         {"tolerance", row.tolerance},
         {"tolerance_scale", row.scale == ToleranceScale::relative ? "relative" : "absolute"},
         {"order", row.order ? Json(*row.order) : Json(nullptr)},
         {"passed", row.passes()},
         {"source", row.source}});
  return json;
}

std::string to_text(const VerificationTable& table) {
  std::size_t widest = 8;
  for (const VerificationRow& row : table) widest = std::max(widest, row.quantity.size());
  std::string text = fmt::format("{:<12}{:<{}}{:>14}{:>14}  {:<4}{:>11}{:>11}{:>7}\n", "rung", "quantity",
                                 widest + 1, "target", "result", "", "deviation", "tolerance", "order");
  for (const VerificationRow& row : table)
    text += fmt::format("{:<12}{:<{}}{:>14.7g}{:>14.7g}  {:<4}{:>11.2e}{:>11.2e}{:>7}{}\n", row.rung,
                        row.quantity, widest + 1, row.target, row.result, row.unit, row.deviation(),
                        row.tolerance, row.order ? fmt::format("{:.2f}", *row.order) : "-",
                        row.passes() ? "" : "  FAILS");
  const auto passed =
      std::count_if(table.begin(), table.end(), [](const auto& row) { return row.passes(); });
  text += fmt::format("{} of {} pass; deviation in the scale of the tolerance\n", passed, table.size());
  return text;
}

}  // namespace rebound
