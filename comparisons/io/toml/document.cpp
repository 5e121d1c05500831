#include "comparisons/io/toml/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "comparisons/io/text.hpp"
#include "comparisons/io/toml/nearest_key.hpp"

namespace rebound {
namespace {

/// Byte offset of a column, which counts code points from 1.
std::size_t byte_offset(std::string_view line, std::size_t column) {
  std::size_t byte = 0;
  for (std::size_t point = 1; point < column && byte < line.size(); ++point) {
    ++byte;
    while (byte < line.size() && (static_cast<unsigned char>(line[byte]) & 0xC0) == 0x80) ++byte;
  }
  return byte;
}

std::string_view line_of(std::string_view text, std::size_t number) {
  for (std::size_t line = 1; line < number; ++line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

/// Key path and value of a line `key = value` the parser stumbled over. The
/// document has no tree then, so the table is the last header above the line.
ErrorLocation location_of_line(std::string_view text, std::size_t number) {
  ErrorLocation location{.line = static_cast<int>(number)};
  const std::string_view line = line_of(text, number);
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) {
    location.value = std::string(trimmed(line));
    return location;
  }
  location.key = std::string(trimmed(line.substr(0, equals)));
  location.value = std::string(trimmed(line.substr(equals + 1)));
  for (std::size_t above = number - 1; above > 0; --above) {
    const std::string_view header = trimmed(line_of(text, above));
    if (!header.starts_with('[')) continue;
    const auto name = header.find_first_not_of('[');
    const auto end = header.find(']');
    if (name < end && end != std::string_view::npos)
      location.key = std::string(header.substr(name, end - name)) + "." + location.key;
    break;
  }
  return location;
}

/// Names the file that was meant, where one beside it has nearly its name.
std::string no_such_file(const std::filesystem::path& file) {
  constexpr int most = 10'000;
  std::vector<std::string> names;
  std::error_code status;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  for (std::filesystem::directory_iterator entry(folder, status), end;
       !status && entry != end && names.size() < most; entry.increment(status))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());  // a folder has no order of its own
  const std::string near = nearest_key(file.filename().string(), names);
  if (near.empty()) return "there is no such file";
  return fmt::format("there is no such file; did you mean {}?",
                     (file.parent_path() / near).string());
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file, std::size_t limit) {
  const ErrorLocation location{.file = file.string()};
  std::error_code status;
  if (std::filesystem::is_directory(file, status))
    throw Error(ExitCode::input_output_failed, "this is a folder, a file is needed", location);
  if (!std::filesystem::exists(file, status))
    throw Error(ExitCode::input_output_failed, no_such_file(file), location);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(ExitCode::input_output_failed, "the file cannot be opened", location);
  std::string text(limit + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw Error(ExitCode::input_output_failed, "the file cannot be read", location);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > limit)
    throw Error(ExitCode::bad_input, fmt::format("the file is longer than {} bytes", limit),
                location);
  return text;
}

Document Document::load(const std::filesystem::path& file) {
  return parse(read_text_file(file), file.string());
}

Document Document::parse(std::string text, std::string name, PlainNumbers plain_numbers) {
  Document document;
  document.plain_numbers_ = plain_numbers;
  document.name_ = std::move(name);
  document.text_ = std::move(text);
  try {
    document.root_ = toml::parse(document.text_, document.name_);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    const bool twice = error.description().find("redefine") != std::string_view::npos;
    ErrorLocation location = location_of_line(document.text_, at.line);
    location.file = document.name_;
    location.column = static_cast<int>(at.column);
    throw Error(ExitCode::bad_input,
                fmt::format("{}: {}", twice ? "the key stands twice" : "this is not valid TOML",
                            error.description()),
                location);
  }
  return document;
}

std::string Document::source_text(const toml::source_region& region) const {
  const std::string_view line = line_of(text_, region.begin.line);
  const std::size_t begin = byte_offset(line, region.begin.column);
  const std::size_t end =
      region.end.line == region.begin.line ? byte_offset(line, region.end.column) : line.size();
  return std::string(line.substr(begin, end > begin ? end - begin : 0));
}

Error Document::error_at(const toml::source_region& region, const std::string& key,
                         const std::string& message, const std::string& allowed) const {
  ErrorLocation location{.file = name_, .key = key, .allowed = allowed};
  if (region.begin) {
    location.line = static_cast<int>(region.begin.line);
    location.column = static_cast<int>(region.begin.column);
    location.value = source_text(region);
  }
  return {ExitCode::bad_input, message, location};
}

Error Document::error_at(const std::string& key, const std::string& message,
                         const std::string& allowed) const {
  if (const auto node = toml::at_path(root_, key); node && !key.empty())
    return error_at(node.node()->source(), key, message, allowed);
  // Not in the file: point at the table it belongs to.
  ErrorLocation location{.file = name_, .key = key, .allowed = allowed};
  const auto parent = toml::at_path(root_, key.substr(0, key.find_last_of('.')));
  if (parent && key.find('.') != std::string::npos) {
    location.line = static_cast<int>(parent.node()->source().begin.line);
    location.column = static_cast<int>(parent.node()->source().begin.column);
  }
  return {ExitCode::bad_input, message, location};
}

Error Document::located(const Error& error) const {
  const ErrorLocation& at = error.location();
  if (!at.file.empty()) return error;
  ErrorLocation location = at.key.empty() ? at : error_at(at.key, "", at.allowed).location();
  location.file = name_;
  if (location.value.empty()) location.value = at.value;
  return {error.code(), error.what(), location};
}

}  // namespace rebound
