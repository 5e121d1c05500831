#include "lumped/integration/composed/composed_integrator.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "lumped/integration/composed/composed_trace.hpp"
#include "lumped/integration/sample_instants.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

/// Turning, parting and touching again. Each is located by a score of trial steps, so that a
/// contact that chatters would take a second, and a fit that strays there hours.
constexpr int most_events = 400;

/// States of most contacts. What few have beyond them costs the others nothing.
constexpr std::size_t most_use = ComposedContact::further_relaxed;

using Event = ComposedContact::Event;

/// Memory of the last integrator of this thread. Steps of one impact take a tenth of a megabyte:
/// asking the system for it anew costs page faults in every impact.
thread_local std::vector<ComposedStepEnd> memory_for_steps;

Error no_way_on() {
  return {ExitCode::solver_failed,
          "a mechanism leaves its range during the contact: the force has no value beyond (the "
          "finite-sphere correction holds as long as the contact gives way more than the body)"};
}

Error chatters() {
  return {ExitCode::solver_failed, "the contact turns, parts or touches again more than " +
                                       std::to_string(most_events) + " times: it chatters"};
}

}  // namespace

ComposedIntegrator::ComposedIntegrator(const ComposedContact& contact)
    : contact_(contact), states_used_(contact.state_count()) {
  const State scales = contact.state_scales();
  for (std::size_t i = 0; i < scales.size(); ++i)
    weight_[i] = 1.0 / (contact.setup().relative_tolerance * scales[i]);
  step_ends_.swap(memory_for_steps);
  step_ends_.clear();
}

ComposedIntegrator::~ComposedIntegrator() {
  step_ends_.swap(memory_for_steps);
}

ComposedIntegrator::Step ComposedIntegrator::step_of(const Start& start, double length) const {
  const auto field = [&](const State& y) {
    State rate;
    contact_.derivative(start.phase, y, rate);
    return rate;
  };
  Step step;
  if (states_used_ == most_use)
    step.take<most_use>(field, start.state, start.rate, length);
  else
    step.take(field, start.state, start.rate, length);
  return step;
}

/// Largest local error over its tolerance; at most 1 in an accepted step.
double ComposedIntegrator::error_norm(const Step& step) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < states_used_; ++i) {
    const double error = std::abs(step.error[i]) * weight_[i];
    if (!(error <= largest)) largest = error;  // keeps a NaN
  }
  return largest;
}

double ComposedIntegrator::indicator_after(Event event, const Start& start, double length) const {
  const Step step = step_of(start, length);
  return contact_.indicator(event, start.phase, step.y, step.derivative);
}

void ComposedIntegrator::watch(Start& start) const {
  start.watched = contact_.event_functions(start.phase);
  for (int i = 0; i < start.watched.count; ++i)
    start.indicators[i] =
        contact_.indicator(start.watched.list[i].event, start.phase, start.state, start.rate);
}

/// Length of the step that ends where the indicator is zero; it changes sign from `before` within
/// `length`.
double ComposedIntegrator::locate(Event event, const Start& start, double before,
                                  double length) const {
  std::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve([&](double h) { return indicator_after(event, start, h); },
                                        0.0, length, before, indicator_after(event, start, length),
                                        boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

ComposedIntegrator::Found ComposedIntegrator::first_event(const Start& start, const Step& step,
                                                          double length) const {
  Found found;
  double limit = length;
  for (int i = 0; i < start.watched.count; ++i) {
    const auto [event, falling] = start.watched.list[i];
    const double sign = falling ? 1.0 : -1.0;
    found.indicators[i] = contact_.indicator(event, start.phase, step.y, step.derivative);
    if (!(sign * start.indicators[i] > 0.0)) continue;
    const double after = found.any ? indicator_after(event, start, limit) : found.indicators[i];
    if (!(sign * after <= 0.0)) continue;  // a NaN is left to the error of the next step
    found.event = event;
    found.length = locate(event, start, start.indicators[i], limit);
    found.any = true;
    // A force that vanishes together with the deflection has a flat zero there:
    // another event counts only when it comes clearly before.
    limit = found.length * (1.0 - 1e-9);
  }
  return found;
}

void ComposedIntegrator::keep(const Start& start, const Step& step, double length) {
  step_ends_.push_back(
      {start.time, length, start.phase, start.state, start.rate, step.y, step.derivative});
}

/// Goes over to the phase after the event; true when the contact has ended.
bool ComposedIntegrator::finish_if_over(const Found& found, Start& start) {
  if (found.event == Event::gone) {
    step_ends_.resize(step_ends_at_release_);
    return true;
  }
  const ComposedEnd here{start.time, start.state, start.phase};
  const auto next = contact_.next_phase(found.event, start.phase, start.state);
  if (!next || next->kind == ContactPhase::Kind::open) {
    end_ = here;
    step_ends_at_release_ = step_ends_.size();
  }
  if (!next) return true;
  start.phase = *next;
  contact_.derivative(start.phase, start.state, start.rate);
  watch(start);
  return false;
}

const ComposedEnd& ComposedIntegrator::integrate() {
  const ContactScales& scales = contact_.scales();
  const double tolerance = contact_.setup().relative_tolerance;
  Start start;
  start.state = contact_.initial_state();
  contact_.derivative(start.phase, start.state, start.rate);
  watch(start);
  step_ends_.clear();
  double h = scales.time * std::pow(tolerance, 0.4);  // forces start with t^1.5
  int events = 0;
  for (int attempt = 0; attempt < contact_.setup().most_steps; ++attempt) {
    Step step = step_of(start, h);
    const double error = error_norm(step);
    if (!std::isfinite(error)) {
      h *= 0.1;
      if (h < 1e-14 * scales.time) throw no_way_on();
      continue;
    }
    if (error <= 1.0) {
      const Found found = first_event(start, step, h);
      double length = h;
      if (found.any) {
        length = found.length;
        step = step_of(start, length);
      }
      keep(start, step, length);
      start.time += length;
      start.state = step.y;
      start.rate = step.derivative;
      start.indicators = found.indicators;
      if (found.any && finish_if_over(found, start)) {
        require_rebound({.velocity = end_.state[ComposedContact::velocity]}, contact_.setup());
        return end_;
      }
      if (start.time > longest_contact * scales.time) throw contact_does_not_end();
      if (found.any && ++events > most_events) throw chatters();
    }
    h *= std::clamp(0.9f * std::pow(static_cast<float>(error), -0.2f), 0.2f, 5.0f);
  }
  throw Error(ExitCode::solver_failed,
              "the fast integrator ran out of steps: something in the contact is too fast for an "
              "explicit method");
}

Trace ComposedIntegrator::sample(const LumpedControls& controls) const {
  std::vector<double> instants(sample_count(controls));
  fill_sample_instants(end_.time, controls, instants);
  TraceRecorder recorder(contact_, instants.size());
  instants.pop_back();  // the end has a state of its own
  std::size_t k = 0;
  for (const double instant : instants) {
    while (k + 1 < step_ends_.size() && step_ends_[k + 1].time <= instant) ++k;
    const ComposedStepEnd& step_end = step_ends_[k];
    const double fraction = (instant - step_end.time) / step_end.length;
    recorder.record(instant, step_end.phase,
                    states_used_ == most_use ? state_within<most_use>(step_end, fraction)
                                             : state_within(step_end, fraction));
  }
  recorder.record(end_.time, end_.phase, end_.state);
  return recorder.take();
}

}  // namespace rebound
