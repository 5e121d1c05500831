#include "comparisons/evaluation/audit/audit_text.hpp"

#include <fmt/format.h>

namespace rebound {
namespace {

const char* name_of(AuditVerdict verdict) {
  switch (verdict) {
    case AuditVerdict::holds: return "holds";
    case AuditVerdict::matters: return "matters";
    case AuditVerdict::fails: return "fails";
    case AuditVerdict::not_run: break;
  }
  return "not-run";
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:>+10.2f}", 100.0 * *value) : fmt::format("{:>10}", "-");
}

}  // namespace

Json to_json(const Audit& audit) {
  Json rows = Json::array();
  for (const auto& row : audit.rows) {
    Json errors = Json::array();
    for (const auto& e : row.errors)
      errors.push_back({{"speed_m_s", e.speed},
                        {"restitution", number_or_null(e.restitution)},
                        {"contact_time", number_or_null(e.contact_time)},
                        {"peak_force", number_or_null(e.peak_force)},
                        {"peak_deflection", number_or_null(e.peak_deflection)}});
    rows.push_back({{"id", row.id},
                    {"assumption", row.assumption},
                    {"number", row.number},
                    {"assumed", row.assumed},
                    {"found", row.found},
                    {"errors", errors},
                    {"verdict", name_of(row.verdict)},
                    {"sentence", row.sentence}});
  }
  return {{"schema", 1}, {"speeds_m_s", audit.speeds}, {"assumptions", rows}};
}

std::string to_text(const Audit& audit) {
  std::string text =
      "errors in per cent (restitution: hundredths): e, contact time, peak force, peak "
      "deflection\n";
  for (const auto& row : audit.rows) {
    text += fmt::format("\n{}: {}\n    {}: {:.4g} (assumed {:g})\n", row.id, row.assumption,
                        row.number, row.found, row.assumed);
    for (const auto& e : row.errors)
      text += fmt::format("    {:>6g} m/s{}{}{}{}\n", e.speed, shown(e.restitution),
                          shown(e.contact_time), shown(e.peak_force), shown(e.peak_deflection));
    text += "    " + row.sentence + "\n";
  }
  return text;
}

}  // namespace rebound
