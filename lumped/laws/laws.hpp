#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "lumped/laws/equivalent_kelvin_voigt.hpp"
#include "lumped/laws/finite_sphere_hertz.hpp"
#include "lumped/laws/hertz_damped.hpp"
#include "lumped/laws/hunt_crossley.hpp"
#include "lumped/laws/kuwabara_kono.hpp"
#include "lumped/laws/linear_kelvin_voigt.hpp"
#include "lumped/laws/power_law.hpp"
#include "lumped/laws/standard_linear_solid.hpp"
#include "lumped/laws/tsuji.hpp"

namespace rebound {

/// The list of contact laws. A law that stands here is known to the
/// configuration, the help, calibration, the integrators and the tests.
using AnyLaw =
    std::variant<LinearKelvinVoigt, EquivalentKelvinVoigt, HuntCrossley, HertzDamped, PowerLaw,
                 KuwabaraKono, Tsuji, FiniteSphereHertz, StandardLinearSolid>;

/// Calls `visit.template operator()<Law>()` for every law of the list.
template <class Visitor>
void for_each_law(Visitor&& visit) {
  [&]<class... Laws>(std::type_identity<std::variant<Laws...>>) {
    (visit.template operator()<Laws>(), ...);
  }(std::type_identity<AnyLaw>{});
}

/// Cards of all laws, in the order of the list.
const std::vector<LawCard>& all_laws();

/// Calls `visit.template operator()<Law>()` for the law of that name alone.
template <class Visitor>
void for_law(const std::string& name, Visitor&& visit) {
  auto card = all_laws().begin();
  for_each_law([&]<class Law>() {
    if ((card++)->name == name) visit.template operator()<Law>();
  });
}

/// Does the law carry a state of its own, a relaxing branch? Then it is integrated as a
/// composed contact, and its `force` is the part without the state.
template <class Law>
inline constexpr bool law_has_branch = requires(const Law law) { law.branch(); };
bool has_branch(const std::string& law);

/// Errors: Error(bad_input) with the names there are.
const LawCard& find_law(const std::string& name);

}  // namespace rebound
