#pragma once

#include "lumped/laws/laws.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Refuses numbers with which no contact can be composed.
///
/// Errors: Error(bad_input) for friction, which no lumped law has a place for;
/// for a plate, branch, mode or memory outside its range; and for damping
/// that would be infinite at first touch.
void check_mechanisms(const Mechanisms& mechanisms, const AnyLaw& law, double radius);

}  // namespace rebound
