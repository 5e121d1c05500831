#include "lumped/integration/check_mechanisms.hpp"

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

void require(bool fine, const std::string& key, double value, const std::string& allowed) {
  if (fine) return;
  throw Error(ExitCode::bad_input, "out of range: " + key + " = " + std::to_string(value),
              {.key = key, .value = std::to_string(value), .allowed = allowed});
}

void check_plate(const Plate& plate) {
  if (plate.friction != 0.0)
    throw Error(ExitCode::bad_input,
                "friction has no lumped form: a contact law's stiffness absorbs it; use the FE tier",
                {.key = "model.plate.friction", .value = std::to_string(plate.friction),
                 .allowed = "0"});
  if (!plate.moves()) return;
  require(plate.stiffness > 0.0, "model.plate.stiffness", plate.stiffness, "above 0 N/m");
  require(plate.mass > 0.0 && std::isfinite(plate.mass), "model.plate.mass", plate.mass,
          "above 0 kg");
  require(plate.damping_ratio >= 0.0 && std::isfinite(plate.damping_ratio),
          "model.plate.damping_ratio", plate.damping_ratio, "0 or above");
}

/// A power of the deflection must not make the damping infinite at first touch.
void check_damping_exponent(const DampingFactors& factors, const AnyLaw& law, double radius) {
  if (factors.exponent >= 0.0) return;
  const double x = 1e-9 * radius;  // small enough for a power law to show its exponent
  const auto force = [&](double at) {
    return std::visit([at](const auto& l) { return l.damping_force(at, 1.0); }, law);
  };
  if (force(x) == 0.0 && force(radius) == 0.0) return;
  const double exponent = std::log2(force(2.0 * x) / force(x));
  require(exponent + factors.exponent > -1e-9, "model.effect.size", factors.exponent,
          "at least minus the damping's own exponent, " + std::to_string(-exponent));
}

}  // namespace

void check_mechanisms(const Mechanisms& mechanisms, const AnyLaw& law, double radius) {
  check_plate(mechanisms.plate);
  check_damping_exponent(mechanisms.damping, law, radius);
  if (mechanisms.relaxation.ratio != 0.0)
    require(mechanisms.relaxation.relaxation_time > 0.0, "model.effect.relaxation_time",
            mechanisms.relaxation.relaxation_time, "above 0 s");
  const double set = mechanisms.memory.permanent_set;
  require(set >= 0.0 && set < 1.0, "model.effect.size", set, "0 <= value < 1");
  const double hysteresis = mechanisms.memory.hysteresis;
  require(hysteresis >= 0.0 && hysteresis <= 1.0, "model.effect.size", hysteresis, "[0, 1]");
  const InternalMode& mode = mechanisms.mode;
  require(mode.mass_fraction >= 0.0 && mode.mass_fraction < 1.0, "model.effect.size",
          mode.mass_fraction, "0 <= value < 1");
  require(mode.frequency > 0.0, "model.effect.frequency", mode.frequency, "above 0 Hz");
}

}  // namespace rebound
