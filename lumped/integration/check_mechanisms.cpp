#include "lumped/integration/check_mechanisms.hpp"

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

void check_plate(const Plate& plate) {
  const KeyPath at{"model.plate"};
  require_limits(plate, at);
  require_limits(plate.frame, {"frame", -1, &at});
  if (plate.friction != 0.0)
    throw Error(
        ExitCode::bad_input,
        "friction has no lumped form: a contact law's stiffness absorbs it; use the FE tier",
        {.key = "model.plate.friction", .value = number_text(plate.friction), .allowed = "0"});
}

/// A power of the deflection must not make the damping infinite at first touch.
void check_damping_exponent(const DampingFactors& factors, const AnyLaw& law, double radius) {
  const double added = factors.exponent + factors.elastic.exponent;
  if (added >= 0.0) return;
  const double x = 1e-9 * radius;  // small enough for a power law to show its exponent
  const auto force = [&](double at) {
    return std::visit([at](const auto& l) { return l.damping_force(at, 1.0); }, law);
  };
  if (force(x) == 0.0 && force(radius) == 0.0) return;
  const double exponent = std::log2(force(2.0 * x) / force(x));
  if (!(exponent + added > -1e-9))
    refuse_value("model.effect.size", added,
                 "at least minus the damping's own exponent, " + number_text(-exponent));
}

}  // namespace

void check_mechanisms(const Mechanisms& mechanisms, const AnyLaw& law, double radius) {
  const KeyPath at{"model.mechanisms"};
  require_limits(mechanisms, at);
  require_limits(mechanisms.elastic, {"elastic", -1, &at});
  require_limits(mechanisms.damping, {"damping", -1, &at});
  require_limits(mechanisms.damping.elastic, {"damping.elastic", -1, &at});
  require_limits(mechanisms.relaxation, {"relaxation", -1, &at});
  for (int k = 0; k < static_cast<int>(mechanisms.further_relaxation.size()); ++k)
    require_limits(mechanisms.further_relaxation[static_cast<std::size_t>(k)],
                   {"further_relaxation", k, &at});
  require_limits(mechanisms.memory, {"memory", -1, &at});
  require_limits(mechanisms.finite_sphere, {"finite_sphere", -1, &at});
  require_limits(mechanisms.mode, {"mode", -1, &at});
  require_limits(mechanisms.pull, {"pull", -1, &at});
  check_plate(mechanisms.plate);
  check_damping_exponent(mechanisms.damping, law, radius);
}

}  // namespace rebound
