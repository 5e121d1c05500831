#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A part of the verification suite that can be computed by itself.
struct SuitePart {
  std::string name;
  double seconds = 1.0;  ///< about: the longest is begun first
  std::function<VerificationPart(const RunControl&)> run;
};

/// What came of the parts, in their order.
struct SuiteOutcome {
  struct Complete {
    std::string name;
    VerificationPart part;
  };
  std::vector<Complete> complete;
  std::vector<std::string> not_run;  ///< by name; empty unless interrupted

  VerificationTable rows() const;
};

/// Computes the parts on two threads. An interruption ends it and leaves what is complete.
/// Errors: those of the parts, but Error(interrupted).
SuiteOutcome run_suite(const std::vector<SuitePart>& parts, const RunControl& control);

}  // namespace rebound
