#include "comparisons/discrepancy/diagnosis/search/record_after_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {
namespace {

constexpr double stretches_a_record = 4.0;  // two contacts after the contact, where recorded
constexpr double plain = 25.0;

/// By how much the χ² of a shot's readings after contact is larger with the faults than without.
double speaks_against(const MeasuredImpact& shot, const std::vector<double>& with,
                      const std::vector<double>& without) {
  const std::vector<double>& measured = shot.after_contact.force;
  const std::size_t count = measured.size();
  const auto contact = static_cast<double>(shot.trace.time.size());
  const auto stretches = static_cast<std::size_t>(
      std::clamp(2.0 * static_cast<double>(count) / contact, 1.0, stretches_a_record));
  double against = 0.0;
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t first = k * count / stretches, last = (k + 1) * count / stretches;
    const auto samples = static_cast<double>(last - first);
    double left_with = 0.0, left_without = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      left_with += (measured[i] - with[i]) / samples;
      left_without += (measured[i] - without[i]) / samples;
    }
    const double independent = std::max(1.0, samples * effective_share(shot.noise.autocorrelation));
    const double error =
        std::hypot(shot.noise.deviation / std::sqrt(independent), shot.noise.zero_error);
    against += (std::pow(left_with, 2) - std::pow(left_without, 2)) / std::pow(error, 2);
  }
  return against;
}

/// The fitted numbers with those of faults where faults are absent; nothing where there is none.
std::optional<std::vector<double>> values_without_faults(const HypothesisFit& fit) {
  std::optional<std::vector<double>> values;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const std::string& name = fit.effects[k].name;
    if (!is_measurement(name)) continue;
    if (!values) values = fit.values;
    for (std::size_t i = 0; i < fit.model->sizes_of_effect(k); ++i)
      (*values)[fit.model->unknowns_of_effect(k)[i]] = find_effect(name).card.null;
  }
  return values;
}

}  // namespace

bool record_after_contact_denies(const Observations& seen, const HypothesisFit& fit) {
  const auto without = values_without_faults(fit);
  if (!without) return false;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    const MeasuredImpact& shot = seen.shots[i];
    const std::vector<double>& time = shot.after_contact.time;
    if (time.empty()) continue;
    if (speaks_against(shot, fit.model->force_at(fit.values, i, time),
                       fit.model->force_at(*without, i, time)) > plain)
      return true;
  }
  return false;
}

}  // namespace rebound
