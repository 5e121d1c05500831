#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"

#include <optional>

namespace rebound {
namespace {

/// Time in which effect k fades, over the mean contact time of the fitted model; nothing for what
/// is no memory of one time.
std::optional<double> fading_over_contact(const Observations& seen, const HypothesisFit& fit,
                                          std::size_t k) {
  const std::string& time = find_effect(fit.effects[k].name).card.fades_in;
  if (time.empty()) return std::nullopt;
  double contact = 0.0;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    contact += fit.model->impact(fit.values, i).scalars.contact_time;
  return fit.effects[k].parameters.at(time) * static_cast<double>(seen.shots.size()) / contact;
}

}  // namespace

EffectFamily acting_family(const Observations& seen, const HypothesisFit& fit, std::size_t k) {
  constexpr double a_damper = 0.02;
  const auto fading = fading_over_contact(seen, fit, k);
  if (fading && *fading < a_damper) return EffectFamily::rate;
  return find_effect(fit.effects[k].name).card.family;
}

bool is_slow_memory_alone(const Observations& seen, const HypothesisFit& fit, std::size_t known) {
  constexpr double slow = 5.0;
  if (fit.effects.size() != known + 1) return false;
  const auto fading = fading_over_contact(seen, fit, known);
  return fading && *fading > slow;
}

}  // namespace rebound
