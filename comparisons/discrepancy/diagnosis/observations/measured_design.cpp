#include "comparisons/discrepancy/diagnosis/observations/measured_design.hpp"

#include <algorithm>
#include <limits>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/observations/prepared_record.hpp"
#include "comparisons/discrepancy/diagnosis/observations/zero_offset.hpp"

namespace rebound {

MeasuredDesign measured_design(const std::vector<Dataset>& datasets, const Observations& all) {
  double noise = 0.0, smallest_peak = std::numeric_limits<double>::infinity();
  for (const Dataset& dataset : datasets) {
    std::vector<MeasuredImpact> shots;
    for (const MeasuredImpact& measured : dataset.shots)
      if (measured.has_history()) shots.push_back(completed(dataset, measured));
    take_out_zero_offset(shots);
    for (const MeasuredImpact& shot : shots) {
      noise = std::max(noise, recorder_of(shot).scatter);
      smallest_peak = std::min(smallest_peak,
                               *std::max_element(shot.trace.force.begin(), shot.trace.force.end()));
    }
  }
  const bool known = noise > 0.0 && smallest_peak > 0.0;
  return {.speeds = static_cast<int>(speed_clusters(all).size()),
          .noise_share = known ? noise / smallest_peak : 0.0};
}

}  // namespace rebound
