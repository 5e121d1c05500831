#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/accuracy/verification/verification_row.hpp"
#include "comparisons/io/report/table.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// A fault of tests/mutations/faults.txt, with what became of it when the
/// script last put it in. Recorded then, not run now.
struct SeededFault {
  /// Stale: the mutated file, or the test that caught it, is no longer what it was then.
  enum class Outcome { not_recorded, caught, survived, stale };
  std::string name;
  std::string file;
  Outcome outcome = Outcome::not_recorded;
  std::string caught_by;  ///< a test that failed, and how many more did
  std::string version;    ///< of the sources it was put into
  std::string date;       ///< of that run
};

/// The list of `folder` with the outcomes of its results.tsv. An outcome counts
/// only for the very line of the list that was run, and for the mutated file and the file of the
/// test that caught it as they were then: it is kept with their digests (digest_of_source).
/// Files are looked for from `sources`.
/// Empty where nothing was ever recorded.
/// Errors: Error(input_output_failed) without a list, Error(corrupt_store) for a
///         line of results that cannot be read.
std::vector<SeededFault> read_seeded_faults(const std::filesystem::path& folder,
                                            const std::filesystem::path& sources);

/// Sixteen digits of the SHA-256 of a source without `//` comments and white space, so that
/// a comment or a line break makes nothing stale; empty where there is no such file.
std::string digest_of_source(const std::filesystem::path& file);

/// Rows: faults that survived, without a recorded outcome, with a stale one; share caught. Empty
/// for an empty list.
VerificationTable rows_of(const std::vector<SeededFault>& faults);

/// The same list for a reader: with version and date, and that it was not run now.
std::string to_text(const std::vector<SeededFault>& faults);
Json to_json(const std::vector<SeededFault>& faults);
report::Table table_of(const std::vector<SeededFault>& faults);

}  // namespace rebound
