#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

MeasuredImpact completed(const Dataset& dataset, MeasuredImpact shot) {
  shot.sphere = dataset.sphere;
  shot.contact_threshold = dataset.instrument.contact_threshold;
  shot.force_bandwidth = dataset.instrument.force_bandwidth;
  shot.force_filter_class = dataset.instrument.force_filter_class;
  shot.noise.deviation = dataset.instrument.force_noise.value_or(0.0);
  shot.deflection = dataset.instrument.deflection;
  shot.deflection_noise.deviation = dataset.instrument.deflection_noise.value_or(0.0);
  return shot;
}

}  // namespace rebound
