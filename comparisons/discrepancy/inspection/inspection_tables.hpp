#pragma once

#include "comparisons/discrepancy/inspection/inspection.hpp"
#include "comparisons/io/report/report.hpp"

/// Tables of an inspection's page. A table without rows says nothing and is left out.
namespace rebound {

report::Table number_table(const Inspection& found);
report::Table coarse_table(const Inspection& found);
report::Table filter_table(const Inspection& found);
report::Table data_check_table(const Inspection& found);
report::Table repeat_table(const Inspection& found);

}  // namespace rebound
