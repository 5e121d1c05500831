#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/report/table.hpp"
#include "comparisons/results/json.hpp"
#include "comparisons/verification/verification_row.hpp"

namespace rebound {

/// A fault of tests/mutations/faults.txt, with what became of it when the
/// script last put it in. Recorded then, not run now.
struct SeededFault {
  enum class Outcome { not_recorded, caught, survived };
  std::string name;
  std::string file;
  Outcome outcome = Outcome::not_recorded;
  std::string caught_by;  ///< a test that failed, and how many more did
  std::string version;    ///< of the sources it was put into
  std::string date;       ///< of that run
};

/// The list of `folder` with the outcomes of its results.tsv. An outcome counts
/// only for the very line of the list that was run: it is kept with its digest.
/// Empty where nothing was ever recorded.
/// Errors: Error(input_output_failed) without a list, Error(corrupt_store) for a
///         line of results that cannot be read.
std::vector<SeededFault> read_seeded_faults(const std::filesystem::path& folder);

/// Where the sources of this build keep them.
std::filesystem::path seeded_faults_folder();

/// Rows: faults that survived, faults without a recorded outcome, share caught. Empty for an empty list.
VerificationTable rows_of(const std::vector<SeededFault>& faults);

/// The same list for a reader: with version and date, and that it was not run now.
std::string to_text(const std::vector<SeededFault>& faults);
Json to_json(const std::vector<SeededFault>& faults);
report::Table table_of(const std::vector<SeededFault>& faults);

}  // namespace rebound
