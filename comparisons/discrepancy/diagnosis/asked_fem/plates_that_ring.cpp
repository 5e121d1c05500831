#include "comparisons/discrepancy/diagnosis/asked_fem/plates_that_ring.hpp"

namespace rebound {

std::vector<EffectChoice> plates_that_ring(const EffectChoice& fault, const Observations& seen) {
  const auto frequency = fault.parameters.find("frequency");
  if (!is_measurement(fault.name) || frequency == fault.parameters.end()) return {};
  const OscillatorCard& plate = *find_effect("plate-compliance").card.oscillator;
  std::vector<EffectChoice> plates;
  for (const double ball_over_plate : {0.01, 0.05})
    plates.push_back(
        plate.with(frequency->second, ball_over_plate, seen.shots.front().sphere.mass));
  return plates;
}

}  // namespace rebound
