#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rebound::testing {

/// Which rooms of the tree may include which, read from a table; see
/// allowed_includes.txt for its form.
class IncludeRules {
 public:
  /// Errors: std::runtime_error for a line without a colon or a room named twice.
  explicit IncludeRules(const std::filesystem::path& table);

  struct Report {
    int files = 0;
    int includes = 0;                     ///< lines read, libraries among them
    std::vector<std::string> violations;  ///< "file:line: why"
  };
  /// Reads every #include of every C++ source below `root`, folders named
  /// build* and hidden ones left out.
  Report check(const std::filesystem::path& root) const;

 private:
  std::string room_of(const std::string& path) const;
  std::string complaint(const std::string& room, const std::string& included) const;
  std::string library_complaint(const std::string& room, const std::string& header) const;

  std::map<std::string, std::vector<std::string>> allowed_;
  std::set<std::string> written_by_the_build_;
  std::vector<std::string> libraries_;  ///< that some room is given
};

}  // namespace rebound::testing
