#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace rebound {

/// A text file line by line in bounded memory: a line without an end, or a file of gigabytes,
/// costs one line.
///
/// Taken away: byte order mark of UTF-8, and line ends, LF or CRLF; blanks stay.
/// Errors: Error(bad_input) with file and line for NUL (a binary file, or UTF-16) and for a line
///         of more than 64 kB; Error(input_output_failed) when the file cannot be read.
class TextLines {
 public:
  explicit TextLines(const std::filesystem::path& file);

  /// The next line, good until the next call; false at the end of the file.
  bool next(std::string_view& line);

  const std::string& name() const { return name_; }
  int number() const { return number_; }              ///< of the line at hand, from 1
  bool is_unfinished() const { return unfinished_; }  ///< the line at hand has no line end

  /// An error at a field of the line at hand. `field` must be a part of the line, or empty.
  [[noreturn]] void refuse(const std::string& reason, const std::string& key = {},
                           std::string_view field = {}, const std::string& allowed = {}) const;

 private:
  std::string name_;
  std::ifstream stream_;
  std::string buffer_;
  std::string_view line_;
  int number_ = 0;
  bool unfinished_ = false;
};

}  // namespace rebound
