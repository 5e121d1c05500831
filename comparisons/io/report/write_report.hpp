#pragma once

#include <filesystem>

#include "comparisons/io/report/report.hpp"

namespace rebound::report {

/// Checks the report (check_report) and writes it as one self-contained HTML file,
/// under a temporary name that is synced and renamed: a reader sees the old file or the
/// whole new one. Folders on the way are made.
///
/// Errors: Error(bad_input) for a report that check_report refuses;
///         Error(input_output_failed) where the file cannot be written.
void write_report(const Report& report, const std::filesystem::path& file);

}  // namespace rebound::report
