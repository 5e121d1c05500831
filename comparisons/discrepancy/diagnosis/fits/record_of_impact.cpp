#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"

#include <algorithm>

#include "comparisons/models/instrument/ring_down.hpp"

namespace rebound {

MeasurementChain stated_chain(const MeasuredImpact& shot) {
  MeasurementChain chain;
  chain.shot = shot.number;
  chain.bandwidth = shot.force_bandwidth.value_or(chain.bandwidth);
  chain.filter_class = shot.force_filter_class.value_or(0.0);
  chain.contact_threshold = shot.contact_threshold.value_or(0.0);
  return chain;
}

Trace contact_and_after(const ModelledImpact& impact, const MeasurementChain& chain,
                        const std::vector<double>& time) {
  return with_ring_down(impact.trace, impact.plate,
                        time.back() - chain.trigger_shift - impact.trace.time.back());
}

double rise_time(const Trace& trace) {
  constexpr double first_rise = 0.3;
  const double level = first_rise * *std::max_element(trace.force.begin(), trace.force.end());
  std::size_t i = 0;
  while (trace.force[i] < level) ++i;
  return trace.time[i];
}

}  // namespace rebound
