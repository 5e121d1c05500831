#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {

/// Reading or writing failed.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// dataset.toml, the only thing beside the CSV files that a diagnosis may see.
std::string dataset_text(const Trial& trial);

/// One record: time_s, force_N.
std::string csv_text(const TrialShot& shot);

/// The believed model: Hunt–Crossley near the baseline.
std::string model_text(const Trial& trial);

/// The label with a nonce, so that nobody can guess the text behind a seal.
std::string truth_text(const Trial& trial, const std::string& nonce);

/// 256 bits of the system's random source, in hexadecimal digits. Not from the seed.
/// Errors: FileError.
std::string fresh_nonce();

/// SHA-256 in hexadecimal digits.
std::string sha256(const std::string& bytes);

/// Writes to a temporary name in the same folder, then renames.
/// Errors: FileError.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// A folder of trials and what has been sealed in it. In this order for each trial: its truth, the
/// list of seals, its data. So no data stand without their seal.
class TrialFolder {
 public:
  /// Errors: FileError.
  explicit TrialFolder(std::filesystem::path folder);
  void add(const Trial& trial);

 private:
  std::filesystem::path folder_;
  std::string seals_;  ///< lines as `sha256sum --check` reads them
};

}  // namespace trials
