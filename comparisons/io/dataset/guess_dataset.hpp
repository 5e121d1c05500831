#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "comparisons/io/laboratory/laboratory_table.hpp"

namespace rebound {

/// What a user says beside a file. Empty: not said; the manifest then holds "?", which no command
/// takes for a number.
struct DatasetHints {
  std::string mass, diameter, speed;  ///< with their units, as typed
};

/// A manifest for a file, for one of the balls in it.
struct GuessedDataset {
  std::string folder;    ///< below the one asked for: "" or "ball-NAME"
  std::string manifest;  ///< text of dataset.toml
};

/// Which column may hold which key of a shot.
struct GuessedColumns {
  std::map<std::string, std::size_t> by_key;
  std::vector<std::string> remarks;  ///< columns that were left out, and why
  int ball = -1;                     ///< column that tells balls apart; -1: none
};

/// By name and unit: drop, rebound, bounce, inbound, outbound, restitution, contact, peak, repeats,
/// file, ball; "sd", "std", "sigma" and "uncertainty" after the same words.
GuessedColumns guess_shot_columns(const TablePreview& preview);

/// Writes commented manifests for a table: a trace, where a time that increases stands beside
/// forces or accelerations in 20 rows or more; else a table of shots. Every guess is marked.
///
///   reversed   where the record's largest swing is downwards
///   baseline   where the first tenth lies off zero by three of its standard errors
///   keep       where the contact is less than a twentieth of the record
///
/// Errors: Error(bad_input) with file and line where the table is none, or holds nothing of an
///         impact.
std::vector<GuessedDataset> guess_dataset(const std::filesystem::path& file,
                                          const DatasetHints& hints);

}  // namespace rebound
