#include "fem/impact/impact_recorder.hpp"

#include "fem/impact/window_scalars.hpp"

namespace rebound::fem {
namespace {

std::size_t expected_samples(double interval, double expected_duration) {
  return static_cast<std::size_t>(2.0 * expected_duration / interval) + 16;
}

}  // namespace

ImpactRecorder::ImpactRecorder(double interval, double expected_duration, Reading reading)
    : interval_(interval),
      reading_(reading),
      contact_(interval, expected_samples(interval, expected_duration)),
      cell_(interval,
            reading == Reading::load_cell ? expected_samples(interval, expected_duration) : 0),
      half_windows_(0.5 * expected_duration / windows_per_contact,
                    static_cast<std::size_t>(4 * windows_per_contact)) {
  const auto samples = expected_samples(interval, expected_duration);
  energies_.reserve(samples);
  for (auto* column : {&time_, &deflection_, &pole_deflection_, &contact_radius_})
    column->reserve(samples);
}

void ImpactRecorder::add_sample(const Sample& sample, const EnergyBalance& energies) {
  time_.push_back(next_sample());
  deflection_.push_back(sample.deflection + 0.0);  // no "-0" at first touch
  pole_deflection_.push_back(sample.pole_deflection + 0.0);
  contact_radius_.push_back(sample.contact_radius);
  if (reading_ == Reading::load_cell) plate_displacement_.push_back(sample.plate_displacement);
  energies_.push_back(energies);
}

Trace ImpactRecorder::trace() const {
  Trace trace;
  trace.time = time_;
  trace.deflection = deflection_;
  trace.further = {{"pole_deflection_m", pole_deflection_}, {"contact_radius_m", contact_radius_}};
  if (reading_ == Reading::contact_force) {
    trace.force = contact_force();
    return trace;
  }
  trace.force = cell_.force(time_.size());
  trace.further.push_back({"contact_force_N", contact_force()});
  trace.further.push_back({"plate_displacement_m", plate_displacement_});
  return trace;
}

}  // namespace rebound::fem
