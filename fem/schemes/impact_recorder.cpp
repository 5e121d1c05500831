#include "fem/schemes/impact_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {

ImpactRecorder::ImpactRecorder(double interval, double expected_duration) : interval_(interval) {
  const auto samples = static_cast<std::size_t>(2.0 * expected_duration / interval) + 16;
  half_bins_.reserve(2 * samples);
  energies_.reserve(samples);
  for (auto* column : {&time_, &deflection_, &pole_deflection_, &contact_radius_})
    column->reserve(samples);
}

void ImpactRecorder::add_impulse(double impulse, double start, double end) {
  if (impulse == 0.0) return;
  total_impulse_ += impulse;
  start = std::max(start, 0.0);
  const double half = 0.5 * interval_;
  const double rate = impulse / (end - start);
  double from = start;
  while (from < end) {
    auto bin = static_cast<std::size_t>(from / half);
    double to = static_cast<double>(bin + 1) * half;
    if (to <= from) to = static_cast<double>(++bin + 1) * half;  // `from` sits on an edge
    to = std::min(to, end);
    if (half_bins_.size() <= bin) half_bins_.resize(bin + 1, 0.0);
    half_bins_[bin] += rate * (to - from);
    from = to;
  }
}

void ImpactRecorder::add_sample(const Sample& sample, const EnergyBook& energies) {
  time_.push_back(next_sample());
  deflection_.push_back(sample.deflection + 0.0);  // no "-0" at first touch
  pole_deflection_.push_back(sample.pole_deflection + 0.0);
  contact_radius_.push_back(sample.contact_radius);
  energies_.push_back(energies);
}

Trace ImpactRecorder::trace() const {
  Trace trace;
  trace.time = time_;
  trace.deflection = deflection_;
  const auto bin = [&](std::size_t i) { return i < half_bins_.size() ? half_bins_[i] : 0.0; };
  const std::size_t n = time_.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double before = k > 0 ? bin(2 * k - 1) : 0.0;
    const double after = k + 1 < n ? bin(2 * k) : 0.0;
    const double length = (k == 0 || k + 1 == n) ? 0.5 * interval_ : interval_;
    trace.force.push_back((before + after) / length);
  }
  trace.further = {{"pole_deflection_m", pole_deflection_}, {"contact_radius_m", contact_radius_}};
  return trace;
}

}  // namespace rebound::fem
