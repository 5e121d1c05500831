#include "lumped/integration/composed/composed_cvode.hpp"

#include <algorithm>

#include "lumped/integration/composed/composed_trace.hpp"
#include "lumped/integration/sample_instants.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr std::size_t most_segments = 1000;

using State = ComposedContact::State;
using Event = ComposedContact::Event;

State state_at(const double* y, std::size_t count) {
  State state{};
  std::copy_n(y, count, state.begin());
  return state;
}

std::vector<double> initial_of(const ComposedContact& contact) {
  const State state = contact.initial_state();
  return {state.begin(), state.begin() + static_cast<std::ptrdiff_t>(contact.state_count())};
}

CvodeSystem system_of(const ComposedContact& contact, const ContactPhase& phase) {
  const std::size_t count = contact.state_count();
  return {.size = count,
          .rate =
              [&, count](const double* y, double* values) {
                State rate;
                contact.derivative(phase, state_at(y, count), rate);
                std::copy_n(rate.begin(), count, values);
              },
          .indicators =
              [&, count](const double* y, double* values) {
                const State state = state_at(y, count);
                const auto event_functions = contact.event_functions(phase);
                for (int i = 0; i < event_functions.count; ++i)
                  values[i] = contact.indicator(event_functions.list[i].event, phase, state);
              }};
}

CvodeTolerances tolerances_of(const ComposedContact& contact) {
  const double relative = contact.setup().relative_tolerance;
  const State scales = contact.state_scales();
  std::vector<double> absolute;
  for (std::size_t i = 0; i < contact.state_count(); ++i) absolute.push_back(relative * scales[i]);
  // What Newton leaves breaks the linear relation of impulse and velocity.
  return {.relative = relative, .absolute = absolute, .newton = 1e-3};
}

}  // namespace

ComposedCvode::ComposedCvode(const ComposedContact& contact)
    : contact_(contact),
      solver_(system_of(contact_, phase_), tolerances_of(contact), initial_of(contact)) {}

void ComposedCvode::begin(const Segment& segment, bool watching) {
  phase_ = segment.phase;
  std::copy_n(segment.state.begin(), contact_.state_count(), solver_.state());
  std::vector<int> directions;
  const auto event_functions = contact_.event_functions(phase_);
  for (int i = 0; watching && i < event_functions.count; ++i)
    directions.push_back(event_functions.list[i].falling ? -1 : 1);
  solver_.restart(segment.start, directions);
}

const ComposedEnd& ComposedCvode::integrate() {
  const double latest = longest_contact * contact_.scales().time;
  segments_ = {{.start = 0.0, .phase = {}, .state = contact_.initial_state()}};
  std::size_t segments_at_release = 0;
  while (segments_.size() < most_segments) {
    begin(segments_.back(), true);
    const auto reached = solver_.advance(latest, "integrating the contact");
    if (!reached.at_event) throw contact_does_not_end();
    const auto first = std::find(reached.events.begin(), reached.events.end(), true);
    const auto event_functions = contact_.event_functions(phase_);
    const Event event =
        event_functions.list[static_cast<std::size_t>(first - reached.events.begin())].event;
    State state = state_at(solver_.state(), contact_.state_count());
    const ComposedEnd here{reached.time, state, phase_};
    const auto next = contact_.next_phase(event, phase_, state);
    const bool gone = event == Event::gone;
    if (!gone && (!next || next->kind == ContactPhase::Kind::open)) {
      end_ = here;
      segments_at_release = segments_.size();
    }
    if (!next) {
      segments_.resize(segments_at_release);
      require_rebound({.velocity = end_.state[ComposedContact::velocity]}, contact_.setup());
      return end_;
    }
    segments_.push_back({reached.time, *next, state});
  }
  throw contact_does_not_end();
}

Trace ComposedCvode::sample(const LumpedControls& controls) {
  std::vector<double> instants(sample_count(controls));
  fill_sample_instants(end_.time, controls, instants);
  TraceRecorder recorder(contact_, instants.size());
  instants.pop_back();  // the end has a state of its own
  std::size_t next = 0;
  for (const double instant : instants) {
    while (next < segments_.size() && segments_[next].start <= instant)
      begin(segments_[next++], false);
    if (instant > segments_[next - 1].start) solver_.advance(instant, "sampling the contact");
    recorder.record(instant, phase_, state_at(solver_.state(), contact_.state_count()));
  }
  recorder.record(end_.time, end_.phase, end_.state);
  return recorder.take();
}

}  // namespace rebound
