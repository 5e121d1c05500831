#include "comparisons/discrepancy/diagnosis/verdict/suspected_fault.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/contradictions.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

namespace rebound {
namespace {

bool follows_from_momentum(const DataCheck& check) {
  constexpr std::array<std::string_view, 5> balances{"impulse", "restitution", "restitution-range",
                                                     "force-over-inertia", "energy"};
  return std::find(balances.begin(), balances.end(), check.what) != balances.end();
}

/// Contradictions of momentum that no fitted model of physics shows: a plate that moves takes
/// impulse, and the fit that holds it may be no candidate.
std::vector<DataCheck> contradictions_of_momentum(const Diagnosis& d, const Observations& all) {
  std::vector<DataCheck> left = d.contradictions;
  std::erase_if(left, [](const DataCheck& one) { return !follows_from_momentum(one); });
  if (left.empty()) return left;
  std::vector<const HypothesisFit*> of_physics{&d.best()};
  for (const AssessedFit& one : d.selection.tried)
    if (!hold_a_fault(one.fit.effects)) of_physics.push_back(&one.fit);
  // A fit whose impact has no end at a speed that it has not seen shows nothing.
  const auto not_shown = fit_each<std::vector<DataCheck>>(
      of_physics.size(), {},
      [&](std::size_t k) { return unexplained_contradictions(d, *of_physics[k], all); });
  for (const auto& beside : not_shown)
    std::erase_if(left, [&](const DataCheck& one) {
      return beside && std::none_of(beside->begin(), beside->end(), [&](const DataCheck& other) {
               return one.what == other.what && one.of == other.of;
             });
    });
  return left;
}

/// Is it one shot that contradicts all others, which agree among themselves? A force on the ball
/// that the sensor does not take up, or another body that is hit, is in all shots.
bool is_of_one_shot(const DataCheck& check, const Observations& all) {
  Observations others = all;
  if (std::erase_if(others.shots,
                    [&](const MeasuredImpact& shot) { return shot.label == check.of; }) != 1)
    return false;
  const std::vector<DataCheck> left = contradictions_among(check_data(others));
  return std::none_of(left.begin(), left.end(), follows_from_momentum);
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

void suspect_a_coarse_recorder(Diagnosis& d, const SelectionRules& rules) {
  const bool is_alike_in_neighbours = d.verdict == DiagnosisVerdict::unexplained &&
                                      d.candidates.empty() &&
                                      d.believed.p_value > rules.smallest_adequate_p;
  if (d.seen->coarse_step == 0.0) return;
  if (d.verdict != DiagnosisVerdict::agrees && !is_alike_in_neighbours) return;
  suspect_measurement(
      d, {{"quantisation"}},
      fmt::format("quantisation: readings are rounded to steps of {:.3g} N, more than twice all "
                  "other noise; within that the model agrees",
                  d.seen->coarse_step));
}

void suspect_an_offset(Diagnosis& d) {
  if (d.verdict != DiagnosisVerdict::agrees || d.seen->zero_offset == 0.0) return;
  suspect_measurement(d, {{"force-baseline"}},
                      fmt::format("force-baseline: the force reads up to {:.3g} N before and after "
                                  "contact; without that the model agrees",
                                  d.seen->zero_offset));
}

void suspect_a_shot_that_no_fit_saw(Diagnosis& d) {
  const std::vector<std::string>& faults = d.selection.faults_of_one_shot;
  if (d.verdict != DiagnosisVerdict::agrees || faults.empty()) return;
  std::vector<std::vector<std::string>> candidates;
  for (const std::string& name : faults) candidates.push_back({name});
  suspect_measurement(d, std::move(candidates),
                      fmt::format("{} at the unseen speed; without that shot the model agrees",
                                  fmt::join(faults, " or ")));
  d.excluded.clear();
}

void suspect_what_contradicts_momentum(Diagnosis& d, const Observations& all) {
  if (d.verdict != DiagnosisVerdict::unexplained) return;
  const std::vector<DataCheck> left = contradictions_of_momentum(d, all);
  if (left.empty()) return;
  const DataCheck& first = left.front();
  const std::string against =
      fmt::format("the {} of {}, by {:.1f} standard deviations, whatever the contact is",
                  first.what, first.of, std::abs(first.deviations()));
  drop_candidates(d);
  d.excluded.clear();
  if (is_of_one_shot(first, all))
    suspect_measurement(d, {},
                        fmt::format("the data contradict themselves in {}; mended by {}", against,
                                    first.mended_by));
  else
    d.withheld = fmt::format(
        "momentum is contradicted in {}: a fault of the measurement that is not in the list, or a "
        "force on the ball that the sensor does not take up",
        against);
}

}  // namespace rebound
