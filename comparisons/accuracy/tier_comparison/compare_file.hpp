#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// One impact, or one at several speeds, in one tier or in both.
struct CompareCase {
  std::string name;                 ///< names its baseline file: letters, digits, - and _
  std::string lumped;               ///< impact file, relative to the compare file; empty: none
  std::string fem;                  ///< likewise
  std::vector<std::string> speeds;  ///< e.g. "15 m/s"; empty: that of the files
  /// How far the tiers may differ beyond their numerical errors, by scalar, relative to FE.
  /// A model gap that is known: without one a gap is told and not judged.
  std::map<std::string, double> agreement;
};

/// What `rebound compare FILE` reads.
struct CompareFile {
  std::vector<CompareCase> cases;
};

void describe(Visitor& visit, CompareCase& one);
void describe(Visitor& visit, CompareFile& file);

/// Scalars that both tiers have and whose error is known, by their keys in results.
const std::vector<std::string>& compared_keys();

/// Reads and checks a compare file.
/// Errors: Error(bad_input) with the key for no case, a case without a tier, names that are taken
/// or
///         are no file names, speeds that are none, agreement of a single tier.
CompareFile read_compare_file(const Document& document);

}  // namespace rebound
