#pragma once

#include "comparisons/io/report/report.hpp"

namespace rebound::report {

/// Refuses a report that would mislead or not draw: missing titles, headline, units or
/// series; vectors of unequal length; numbers that are not finite; a band whose edges do
/// not enclose its line; a measured line; a hatched cell without a meaning; a row without
/// its cells; an animation whose frames or cells lack vertices; a link to an overlay that is not
/// there; ids used twice.
///
/// Errors: Error(bad_input) that names the section, the block and what is wrong.
void check_report(const Report& report);

}  // namespace rebound::report
