#include "comparisons/app/report_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/file_errors.hpp"

namespace rebound {
namespace {

std::string shortened(const std::string& value) {
  constexpr std::size_t longest = 200;  // a line of a million characters helps nobody
  return value.size() <= longest ? value : value.substr(0, longest) + "...";
}

Error with_short_value(const Error& error) {
  ErrorLocation location = error.location();
  location.value = shortened(location.value);
  return {error.code(), error.what(), location};
}

std::string text_of(const Error& error) {
  const ErrorLocation& at = error.location();
  std::string text = "rebound: ";
  if (!at.file.empty()) text += at.file;
  if (at.line > 0) text += fmt::format(":{}", at.line);
  if (at.line > 0 && at.column > 0) text += fmt::format(":{}", at.column);
  if (!at.file.empty()) text += ": ";
  if (!at.key.empty()) text += at.key;
  if (!at.key.empty() && !at.value.empty()) text += " = ";
  if (!at.value.empty()) text += shortened(at.value);
  if (!at.key.empty() || !at.value.empty()) text += ": ";
  text += error.what();
  if (!at.allowed.empty()) text += "\n         allowed: " + at.allowed;
  return text + "\n";
}

/// All errors where one file has several, else the one.
std::vector<Error> all_of(const Error& error) {
  if (const auto* several = dynamic_cast<const FileErrors*>(&error)) return several->errors();
  return {error};
}

}  // namespace

int report_error(const Error& error, bool as_json) {
  const std::vector<Error> all = all_of(error);
  if (as_json) {
    Json json = to_json(with_short_value(error));
    if (all.size() > 1)
      for (const Error& one : all)
        json["errors"].push_back(to_json(with_short_value(one))["error"]);
    fmt::print(stdout, "{}", dump(json));
  } else {
    for (const Error& one : all) fmt::print(stderr, "{}", text_of(one));
    if (all.size() > 1)
      fmt::print(stderr, "rebound: {} errors in {}\n", all.size(), error.location().file);
  }
  return static_cast<int>(error.code());
}

}  // namespace rebound
