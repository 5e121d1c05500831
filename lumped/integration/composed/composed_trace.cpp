#include "lumped/integration/composed/composed_trace.hpp"

namespace rebound {

TraceRecorder::TraceRecorder(const ComposedContact& contact, std::size_t size) : contact_(contact) {
  trace_.time.reserve(size);
  trace_.force.reserve(size);
  trace_.deflection.reserve(size);
  if (!contact.plate_moves()) return;
  trace_.further = {{"contact_force_N", {}}, {"plate_displacement_m", {}}};
  if (contact.frame_moves()) trace_.further.push_back({"frame_displacement_m", {}});
  for (auto& column : trace_.further) column.values.reserve(size);
}

void TraceRecorder::record(double time, const ContactPhase& phase,
                           const ComposedContact::State& state) {
  trace_.time.push_back(time);
  trace_.force.push_back(contact_.instrument_force(phase, state));
  trace_.deflection.push_back(contact_.centre_of_mass_deflection(phase, state));
  if (!contact_.plate_moves()) return;
  trace_.further[0].values.push_back(contact_.contact_force(phase, state));
  trace_.further[1].values.push_back(state[ComposedContact::plate_displacement]);
  if (contact_.frame_moves())
    trace_.further[2].values.push_back(state[ComposedContact::frame_displacement]);
}

}  // namespace rebound
