#pragma once

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// Makes the trace of a composed contact from its states: what the instrument
/// reads, the deflection of the centre of mass, and, where the plate moves, the
/// contact force beside what the load cell reads, and the plate's displacement.
class TraceRecorder {
 public:
  TraceRecorder(const ComposedContact& contact, std::size_t samples);
  void record(double time, const ContactPhase& phase, const ComposedContact::State& state);
  Trace take() { return std::move(trace_); }

 private:
  const ComposedContact& contact_;
  Trace trace_;
};

}  // namespace rebound
