#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "lumped/laws/law_card.hpp"
#include "lumped/laws/law_headers.hpp"  // written by CMake from laws.inc
#include "lumped/problem/error.hpp"

namespace rebound {

template <class, class... Laws>
using VariantOf = std::variant<Laws...>;

#define REBOUND_LAW(Law) , Law
/// Any law of the list. What stands in laws.inc is known to the configuration,
/// the help, calibration, the integrators and the tests.
using AnyLaw = VariantOf<void
#include "lumped/laws/laws.inc"
                         >;
#undef REBOUND_LAW

/// Calls `visit.template operator()<Law>()` for every law of the list.
template <class Visitor>
void for_each_law(Visitor&& visit) {
  [&]<class... Laws>(std::type_identity<std::variant<Laws...>>) {
    (visit.template operator()<Laws>(), ...);
  }(std::type_identity<AnyLaw>{});
}

/// Calls `visit.template operator()<Law>()` for the law of that name alone.
template <class Visitor>
void for_law(const std::string& name, Visitor&& visit) {
  auto card = all_laws().begin();
  for_each_law([&]<class Law>() {
    if ((card++)->name == name) visit.template operator()<Law>();
  });
}

/// has_branch() of a type.
template <class Law>
inline constexpr bool law_has_branch = requires(const Law law) {
  law.branch();
};

/// std::visit over the laws without a state of their own: nothing is compiled for the others.
/// Errors: Error(bad_input) for a law with a state of its own.
template <class Visitor>
decltype(auto) visit_stateless(Visitor&& visitor, const AnyLaw& law) {
  using Result = std::invoke_result_t<Visitor, const std::variant_alternative_t<0, AnyLaw>&>;
  return std::visit(
      [&]<class Law>(const Law& one) -> Result {
        if constexpr (law_has_branch<Law>)
          throw Error(ExitCode::bad_input, "the law has a state of its own",
                      {.key = "law", .value = Law::card().name, .allowed = "a law without memory"});
        else
          return visitor(one);
      },
      law);
}

}  // namespace rebound
