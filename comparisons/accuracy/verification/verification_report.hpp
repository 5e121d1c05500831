#pragma once

#include "comparisons/accuracy/verification/verification_suite.hpp"
#include "comparisons/io/report/report.hpp"

namespace rebound {

/// The verification suite as a page: the pictures of its parts, every row with its verdict,
/// and what an interruption left out.
report::Report verification_report(const SuiteOutcome& suite);

}  // namespace rebound
