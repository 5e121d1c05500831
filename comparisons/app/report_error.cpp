#include "comparisons/app/report_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "comparisons/io/results/json.hpp"

namespace rebound {
namespace {

std::string shortened(const std::string& value) {
  constexpr std::size_t longest = 200;  // a line of a million characters helps nobody
  return value.size() <= longest ? value : value.substr(0, longest) + "...";
}

}  // namespace

int report_error(const Error& error, bool as_json) {
  const ErrorLocation& at = error.location();
  if (as_json) {
    ErrorLocation location = at;
    location.value = shortened(at.value);
    fmt::print(stdout, "{}", dump(to_json(Error(error.code(), error.what(), location))));
  } else {
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
    fmt::print(stderr, "{}\n", text);
  }
  return static_cast<int>(error.code());
}

}  // namespace rebound
