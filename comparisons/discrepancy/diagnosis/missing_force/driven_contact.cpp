#include "comparisons/discrepancy/diagnosis/missing_force/driven_contact.hpp"

namespace rebound {
namespace {

using State = ComposedContact::State;

State moved(const State& from, const State& rate, double step) {
  State to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += step * rate[i];
  return to;
}

}  // namespace

std::string why_not_driven(const LumpedModel& model) {
  if (model.mechanisms.plate.moves()) return "the plate of the believed model moves";
  if (model.mechanisms.mode.mass_fraction != 0.0)
    return "the ball of the believed model has an inner mass";
  return {};
}

DrivenContact::DrivenContact(const LumpedProblem& problem)
    : contact_(problem), state_(contact_.initial_state()) {}

double DrivenContact::force() const {
  return over_ ? 0.0 : contact_.contact_force(phase_, state_);
}

/// Central difference of the force by one state.
double DrivenContact::slope(std::size_t state, double difference) const {
  if (over_) return 0.0;
  State above = state_, below = state_;
  above[state] += difference;
  below[state] -= difference;
  return (contact_.contact_force(phase_, above) - contact_.contact_force(phase_, below)) /
         (2.0 * difference);
}

double DrivenContact::by_deflection() const {
  return slope(ComposedContact::approach, 1e-4 * scales().deflection);
}

double DrivenContact::by_velocity() const {
  return slope(ComposedContact::velocity, 1e-4 * contact_.setup().speed);
}

template <class Field>
void DrivenContact::take_step(const Field& field, double step) {
  const State before = state_;
  const State k1 = field(before, 0.0);
  const State k2 = field(moved(before, k1, 0.5 * step), 0.5);
  const State k3 = field(moved(before, k2, 0.5 * step), 0.5);
  const State k4 = field(moved(before, k3, step), 1.0);
  for (std::size_t i = 0; i < state_.size(); ++i)
    state_[i] += step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
  if (!over_) enter_next_phase(before);
}

void DrivenContact::enter_next_phase(const State& before) {
  const auto watched = contact_.event_functions(phase_);
  for (int i = 0; i < watched.count; ++i) {
    const auto [event, falling] = watched.list[i];
    const double sign = falling ? 1.0 : -1.0;
    if (!(sign * contact_.indicator(event, phase_, before) > 0.0)) continue;
    if (sign * contact_.indicator(event, phase_, state_) > 0.0) continue;
    const auto next = contact_.next_phase(event, phase_, state_);
    if (next)
      phase_ = *next;
    else
      over_ = true;
    return;
  }
}

void DrivenContact::advance_to(double velocity, double step) {
  const double from = this->velocity();
  take_step(
      [&](State y, double share) {
        y[ComposedContact::velocity] = from + share * (velocity - from);
        State rate{};
        if (!over_) contact_.derivative(phase_, y, rate);
        rate[ComposedContact::velocity] = (velocity - from) / step;
        return rate;
      },
      step);
  deflection_ += 0.5 * step * (from + velocity);
}

void DrivenContact::advance_with(const std::function<double(double, double)>& added, double step) {
  const double mass = contact_.setup().mass, from = velocity(), x = deflection_;
  take_step(
      [&](const State& y, double share) {
        State rate{};
        const double v = y[ComposedContact::velocity];
        if (!over_) contact_.derivative(phase_, y, rate);
        rate[ComposedContact::velocity] -= added(x + 0.5 * share * step * (from + v), v) / mass;
        return rate;
      },
      step);
  deflection_ += 0.5 * step * (from + velocity());
}

Trace impact_with(const LumpedProblem& problem, const ForceBeside& beside) {
  constexpr double steps = 200.0, longest = 10.0;  // of a scale of time
  DrivenContact contact(problem);
  const double step = contact.scales().time / steps;
  const double last = longest * contact.scales().time;
  Trace trace;
  for (double t = 0.0; t < last; t += step) {
    const double x = contact.deflection(), v = contact.velocity();
    trace.time.push_back(t);
    trace.deflection.push_back(x);
    if (t > 0.0 && beside.over(x, v)) break;
    trace.force.push_back(contact.force() + beside.force(x, v));
    contact.advance_with(beside.force, step);
  }
  trace.force.resize(trace.time.size(), 0.0);
  return trace;
}

}  // namespace rebound
