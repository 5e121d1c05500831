#pragma once

#include "comparisons/io/report/report.hpp"

/// Blocks of the demo report that are of no ball: TEST DATA, and saying so.
namespace rebound::report_tests {

/// A half-disc of polar cells that is pressed flat and springs back, by formula alone.
report::Animation squeezed_disc();

report::Table checks_table();
/// Wider than a telephone, with its verdicts at the far end.
report::Table wide_table();
report::Table linked_table();

}  // namespace rebound::report_tests
