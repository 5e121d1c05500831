#include "comparisons/discrepancy/diagnosis/verdict/contradictions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "comparisons/discrepancy/diagnosis/data_checks/force_before_touch.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

namespace rebound {
namespace {

/// Faults that change the force whether or not there is a contact.
bool shows_before_touch(const std::string& name) {
  constexpr std::array<std::string_view, 4> faults{"force-drift", "hum", "burst", "quantisation"};
  return std::find(faults.begin(), faults.end(), name) != faults.end();
}

}  // namespace

std::vector<DataCheck> unexplained_contradictions(const Diagnosis& d, const HypothesisFit& fit,
                                                  const Observations& all) {
  Hypothesis hypothesis = fit.hypothesis;
  hypothesis.effects = fit.effects;
  const JointModel model(all, hypothesis);
  const std::vector<double> values = model.without_nuisances(values_from(fit, model));
  Observations predicted = all;
  for (std::size_t i = 0; i < all.shots.size(); ++i) predicted.shots[i] = model.as_seen(values, i);
  const std::vector<DataCheck> by_model = check_data(predicted);
  const double limit = contradiction_limit(d.checks.size());
  std::vector<DataCheck> left;
  for (const DataCheck& one : d.contradictions) {
    const auto same = std::find_if(by_model.begin(), by_model.end(), [&](const DataCheck& other) {
      return other.what == one.what && other.of == one.of;
    });
    const double explained =
        same == by_model.end() ? 0.0 : (same->measured - same->expected) / one.error;
    // Sixty deviations are not predicted to four: a quarter of them may be missed.
    constexpr double missed = 0.25;
    if (std::abs(one.deviations() - explained) > limit + missed * std::abs(explained))
      left.push_back(one);
  }
  return left;
}

void withhold_names_from_contradictions(Diagnosis& d, const Observations& all) {
  const bool names_physics =
      d.verdict == DiagnosisVerdict::missing &&
      std::any_of(d.effects.begin(), d.effects.end(),
                  [](const NamedEffect& one) { return !is_measurement(one.effect.name); });
  if (!names_physics || d.contradictions.empty()) return;
  const std::vector<DataCheck> left = unexplained_contradictions(d, d.best(), all);
  if (left.empty()) return;
  withhold(d, without_name(d),
           fmt::format("the data contradict themselves in the {} of {}, by {:.1f} standard "
                       "deviations, and {} does not say why",
                       left.front().what, left.front().of, std::abs(left.front().deviations()),
                       label_of(d.best().effects)));
}

void withhold_what_acts_before_touch(Diagnosis& d) {
  const auto found = std::find_if(d.contradictions.begin(), d.contradictions.end(),
                                  [](const DataCheck& one) { return one.what == before_touch; });
  const bool is_said = std::any_of(d.candidates.begin(), d.candidates.end(), [](const auto& names) {
    return std::any_of(names.begin(), names.end(), shows_before_touch);
  });
  if (found == d.contradictions.end() || is_said) return;
  withhold(d, DiagnosisVerdict::unexplained,
           fmt::format("the force changes by {:+.3g} N before the first touch, by {:.1f} standard "
                       "deviations: something acts at a distance or on the sensor, which no effect "
                       "of the list does",
                       found->measured, std::abs(found->deviations())));
  d.excluded.clear();
}

}  // namespace rebound
