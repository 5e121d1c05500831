#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/io/results/json.hpp"
#include "comparisons/studies/reproduce/findings.hpp"

namespace rebound {

/// The paper's numbers checked against each other.
struct Reproduction {
  Paper paper;
  std::vector<std::vector<ModelRun>> runs;  ///< the published models, [core][speed]
  std::vector<Row> rows;                    ///< Tables 2 to 5, then the claims of the text
  std::vector<BlockSearch> searches;        ///< for the change that repairs a block
  std::vector<Finding> findings;

  std::size_t count(Verdict verdict) const;
};

/// Reads the paper's data below `data_folder` and does it all; some tenths of
/// a second. Errors: as read_paper() and claim_rows().
Reproduction reproduce(const std::filesystem::path& data_folder);

/// {"schema": 1, "rows": […], "findings": […], "counts": {…}, "repairs": […]}.
///
/// A row: table, core (null: all), speed_m_s (null: all), quantity, published,
/// computed, low, high, verdict; beside them half_width, unit_si ("%" stays per
/// cent) and the number as printed with its unit.
Json to_json(const Reproduction& reproduction);

/// Counts, rows with those that differ first, findings.
std::string to_text(const Reproduction& reproduction);

/// Rows with those that differ first, then those within rounding; the paper's
/// order within each.
std::vector<Row> differences_first(const std::vector<Row>& rows);

}  // namespace rebound
