#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

/// What a number without a unit means where a unit is asked for.
enum class PlainNumbers {
  refused,  ///< as in files, where a reader cannot ask what was meant
  are_si    ///< in input that a program made
};

/// A TOML file in memory, with the means to point at any part of it.
class Document {
 public:
  /// Errors: Error(input_output_failed) for a file that cannot be read,
  /// Error(bad_input) for text that is not TOML, with line and column.
  static Document load(const std::filesystem::path& file);
  static Document parse(std::string text, std::string name,
                        PlainNumbers plain_numbers = PlainNumbers::refused);

  const toml::table& root() const { return root_; }
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  PlainNumbers plain_numbers() const { return plain_numbers_; }
  std::filesystem::path folder() const { return std::filesystem::path(name_).parent_path(); }

  /// An error at a node; its value is quoted as the user wrote it.
  Error error_at(const toml::source_region& region, const std::string& key,
                 const std::string& message, const std::string& allowed = {}) const;

  /// An error at a key path such as "model.material.branch[0].ratio"; for
  /// checks that need more than one value. A path that is not in the file
  /// gives an error without line.
  Error error_at(const std::string& key, const std::string& message,
                 const std::string& allowed = {}) const;

  /// An error of a room that knows key paths but not files, with this file
  /// and, where the key stands in it, line, column and value added.
  Error located(const Error& error) const;

  /// Does what is asked; errors get their place in this file.
  template <class Work>
  void locating(const Work& work) const {
    try {
      work();
    } catch (const Error& error) {
      if (!error.location().file.empty()) throw;  // as it is: it may hold more than one
      throw located(error);
    }
  }

 private:
  std::string source_text(const toml::source_region& region) const;

  std::string name_;
  std::string text_;
  PlainNumbers plain_numbers_ = PlainNumbers::refused;
  toml::table root_;
};

/// The whole of a small text file.
/// Errors: Error(input_output_failed) when it is missing, a directory, not
/// readable or longer than `limit` bytes.
std::string read_text_file(const std::filesystem::path& file, std::size_t limit = 1 << 22);

}  // namespace rebound
