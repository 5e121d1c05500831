#pragma once

#include <gtest/gtest.h>

#include "lumped/problem/error.hpp"

namespace rebound::testing {

/// Runs something that must be refused and returns the refusal.
template <class Action>
Error refusal_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was refused";
  return {ExitCode::done, ""};
}

}  // namespace rebound::testing
