#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/result_store/stored_member.hpp"

namespace rebound {

/// A finished member as it is kept.
struct KeptMember {
  std::string key;
  std::string factors;  ///< JSON of the factors' values, for whoever reads the file with SQL
  MemberResult result;
};

/// Results of members (of a campaign, of the atlas, of trials) in one SQLite file, by their keys;
/// write-ahead log, so that a process that is killed loses nothing that was kept -> test
/// CampaignCommand.KilledAtAnyTimeItGoesOnToTheSameBits. Two processes may write to one file: each
/// waits for the other.
///
///   member       key, one column a scalar, failure, factors, number of named values,
///                packed trace, checksum
///   named_value  key, place, name, number or text: of members that are no impacts
///   campaign     sha256, and the texts and names of both files
///   about        program: version that made the results
///
/// Errors of all members: Error(corrupt_store) for a file that is none, is damaged, is of another
/// version of the format or was written by another program; it is left as it is.
/// Error(input_output_failed) where reading or writing fails, a full disk among them; what was
/// kept before stays -> test CampaignCommand.AFullDiskLosesNothing.
class ResultStore {
 public:
  enum class Access { read, write };

  /// Opens a store; to write, it is made where it is not there, whole or not at all.
  ResultStore(const std::filesystem::path& file, Access access, const std::string& program);
  /// Opens a store to read it, whatever program it is of.
  explicit ResultStore(const std::filesystem::path& file);
  ~ResultStore();
  ResultStore(ResultStore&&) noexcept;

  std::optional<MemberResult> find(const std::string& key);
  /// Many finds in one transaction, which locks the file once. Nothing is kept meanwhile.
  void find_each(const std::vector<std::string>& keys,
                 const std::function<void(std::size_t, MemberResult)>& found);
  /// In one transaction: all are kept, or none. Those that are there already stay.
  void keep(const std::vector<KeptMember>& members);

  /// `digest` of both texts.
  void keep_campaign(const std::string& digest, const CampaignText& text);
  std::vector<CampaignText> campaigns();

  const std::filesystem::path& file() const;
  const std::string& program() const;  ///< that its results are of

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

/// Files of a store's folder in the order of their names, or the one file itself.
/// Errors: Error(input_output_failed) where there is none.
std::vector<std::filesystem::path> store_files(const std::filesystem::path& store);

}  // namespace rebound
