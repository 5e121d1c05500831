#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "comparisons/discrepancy/diagnosis/verdict/contradictions.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

namespace rebound {
namespace {

bool follows_from_momentum(const DataCheck& check) {
  constexpr std::array<std::string_view, 5> balances{"impulse", "restitution", "restitution-range",
                                                     "force-over-inertia", "energy"};
  return std::find(balances.begin(), balances.end(), check.what) != balances.end();
}

}  // namespace

void suspect_measurement(Diagnosis& d, std::vector<std::vector<std::string>> candidates,
                         std::string fault) {
  d.verdict = DiagnosisVerdict::measurement_fault;
  d.family = EffectFamily::measurement;
  d.candidates = std::move(candidates);
  d.fault = std::move(fault);
  d.withheld.clear();
}

void suspect_a_coarse_recorder(Diagnosis& d) {
  if (d.verdict != DiagnosisVerdict::agrees || d.seen->coarse_step == 0.0) return;
  suspect_measurement(
      d, {{"quantisation"}},
      fmt::format("quantisation: readings are rounded to steps of {:.3g} N, more than twice all "
                  "other noise; within that the model agrees",
                  d.seen->coarse_step));
}

void suspect_what_contradicts_momentum(Diagnosis& d, const Observations& all) {
  if (d.verdict != DiagnosisVerdict::unexplained) return;
  std::vector<DataCheck> left = unexplained_contradictions(d, all);
  std::erase_if(left, [](const DataCheck& one) { return !follows_from_momentum(one); });
  if (left.empty()) return;
  const DataCheck& first = left.front();
  drop_candidates(d);
  d.excluded.clear();
  suspect_measurement(
      d, {},
      fmt::format("the data contradict themselves in the {} of {}, by {:.1f} standard deviations, "
                  "whatever the contact is; mended by {}",
                  first.what, first.of, std::abs(first.deviations()), first.mended_by));
}

}  // namespace rebound
