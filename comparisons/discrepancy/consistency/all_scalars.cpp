#include "comparisons/discrepancy/consistency/all_scalars.hpp"

#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"

namespace rebound {

Observations all_scalars(const Dataset& data, const AssumedErrors& assumed) {
  Dataset complete = data;
  complete.instrument.deflection = DeflectionOrigin::independent;
  for (MeasuredImpact& shot : complete.shots) {
    shot.trace = {};  // scalars alone are held against each other
    shot.trace_file.clear();
    shot.deflection = DeflectionOrigin::independent;
    if (Measured& mean = shot.mean_deflection; mean.value && !mean.is_stated())
      mean.uncertainty = assumed.mean_deflection * *mean.value;
    for (const PooledPeak& peak : complete.pooled_peaks) {
      if (peak.speed != shot.impact.speed) continue;
      const double share = peak.scatter.value_or(assumed.pooled_peak);
      if (!shot.peak_force.value) shot.peak_force = {peak.force, share * peak.force};
      if (!shot.peak_deflection.value)
        shot.peak_deflection = {peak.deflection, share * peak.deflection};
    }
  }
  return observe({complete});
}

}  // namespace rebound
