#pragma once

#include <optional>
#include <utility>

#include "comparisons/config/visitor.hpp"

namespace rebound {

/// An optional number that stays unwritten at its default.
inline void number_unless(Visitor& visit, double fallback, Key key, double& member) {
  key.presence = Presence::optional;
  auto value = member == fallback ? std::nullopt : std::optional(member);
  visit.number(std::move(key), value);
  member = value.value_or(fallback);
}

}  // namespace rebound
