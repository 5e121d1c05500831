// What ends a phase of a composed contact, and what follows it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"

namespace rebound {

using Kind = ContactPhase::Kind;
using State = ComposedContact::State;

bool ComposedContact::remembers() const {
  return mechanisms_.memory != UnloadingMemory{} || pulls();
}

ComposedContact::EventFunctions ComposedContact::event_functions(const Phase& phase) const {
  if (phase.kind == Kind::open) return {{{{Event::touching, false}, {Event::gone, true}}}, 2};
  if (phase.kind == Kind::pulled) return {{{{Event::touching, false}, {Event::ruptured, true}}}, 2};
  EventFunctions event_functions;
  event_functions.list[event_functions.count++] = {Event::separated, true};
  if (setup_.separation == SeparationRule::zero_force)
    event_functions.list[event_functions.count++] = {Event::released, true};
  if (phase.kind == Kind::below)
    event_functions.list[event_functions.count++] = {Event::reloading, false};
  else if (remembers())
    event_functions.list[event_functions.count++] = {Event::turning, true};
  return event_functions;
}

double ComposedContact::indicator(Event event, const Phase& phase, const State& y) const {
  const double left = deflection_left(phase, y);
  switch (event) {
    case Event::turning: return closing_speed(y);
    case Event::reloading: return y[approach] - phase.largest;
    case Event::released: return forces(phase, y).without_adhesion();
    case Event::separated:
      return setup_.separation == SeparationRule::zero_force ? left
                                                             : centre_of_mass_deflection(phase, y);
    case Event::ruptured: return reach_of_pulls() + left;
    case Event::touching: {
      // Clear of the zero at which they parted, or rounding would close it again.
      constexpr double clearance = 1e-6;
      return std::min(forces(phase, y).without_adhesion() / peak_force_,
                      left / scales_.deflection) -
             clearance;
    }
    case Event::gone: {
      double reach = y[velocity] < 0.0 ? centre_of_mass_deflection(phase, y) : scales_.deflection;
      if (plate_.moves())
        reach += plate_reach(plate_, plate_energy(plate_, plate_motion(y), frame_motion(y)));
      const InternalMode& mode = mechanisms_.mode;
      if (mode.mass_fraction != 0.0)
        reach += mode.mass_fraction *
                 std::hypot(y[mode_displacement], y[mode_velocity] / mode_angular_frequency(mode));
      return reach;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ComposedContact::indicator(Event event, const Phase& phase, const State& y,
                                  const State& rate) const {
  // In contact, and where nothing pulls, the force is what acts: it has been asked for.
  if (event == Event::released && !pulls()) return rate[impulse];
  return indicator(event, phase, y);
}

/// The ball leaves faster than anything that rings can follow, or not.
bool ComposedContact::may_touch_again(const State& y) const {
  double fastest = 0.0;
  if (plate_.moves())
    fastest +=
        std::sqrt(2.0 * plate_energy(plate_, plate_motion(y), frame_motion(y)) / plate_.mass);
  const InternalMode& mode = mechanisms_.mode;
  if (mode.mass_fraction != 0.0)
    fastest += mode.mass_fraction *
               std::hypot(y[mode_velocity], mode_angular_frequency(mode) * y[mode_displacement]);
  return fastest > 0.0 && !(-y[velocity] > fastest);
}

std::optional<ContactPhase> ComposedContact::next_phase(Event event, const Phase& phase,
                                                        State& y) const {
  switch (event) {
    case Event::turning: return Phase{Kind::below, y[approach]};
    case Event::reloading: return Phase{Kind::loading, 0.0};
    case Event::touching: {
      const Phase next = remembers() ? Phase{Kind::below, phase.largest} : Phase{};
      y[dissipated] -= stored_energy(next, y);
      return next;
    }
    case Event::released:
    case Event::separated:
      if (reach_of_pulls() > 0.0) {
        y[dissipated] += stored_energy(phase, y);
        return Phase{Kind::pulled, phase.kind == Kind::loading ? y[approach] : phase.largest};
      }
      [[fallthrough]];
    case Event::ruptured: {
      if (setup_.separation != SeparationRule::zero_force || !may_touch_again(y)) return {};
      if (!phase.apart())
        y[dissipated] += stored_energy(phase, y);  // what the ball holds while it is free
      return Phase{Kind::open, phase.kind == Kind::loading ? y[approach] : phase.largest};
    }
    case Event::gone: break;
  }
  return {};
}

}  // namespace rebound
