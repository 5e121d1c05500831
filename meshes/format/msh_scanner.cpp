#include "meshes/format/msh_scanner.hpp"

#include <charconv>

#include "lumped/problem/error.hpp"

namespace rebound {

void MshScanner::refuse(const std::string& reason) const {
  throw Error(ExitCode::bad_input, reason, {.file = file_, .line = line_});
}

void MshScanner::skip_space() {
  while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t' ||
                            rest_.front() == '\r' || rest_.front() == '\n')) {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
}

std::string_view MshScanner::word() {
  skip_space();
  if (rest_.empty()) refuse("the mesh file ends early");
  const std::string_view found = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
  rest_.remove_prefix(found.size());
  return found;
}

bool MshScanner::find_section(std::string_view name) {
  const std::string_view rest = rest_;
  const int line = line_;
  for (skip_space(); !rest_.empty(); skip_space())
    if (const std::string_view found = word(); found.starts_with('$') && found.substr(1) == name)
      return true;
  rest_ = rest;
  line_ = line;
  return false;
}

void MshScanner::end_section(std::string_view name) {
  if (word() != "$End" + std::string(name))
    refuse("section $" + std::string(name) + " does not end where its counts say");
}

long MshScanner::whole(const char* what) {
  const std::string_view text = word();
  long value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size())
    refuse(std::string(what) + ": \"" + std::string(text.substr(0, 40)) + "\" is no whole number");
  return value;
}

double MshScanner::number(const char* what) {
  const std::string_view text = word();
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size())
    refuse(std::string(what) + ": \"" + std::string(text.substr(0, 40)) + "\" is no number");
  return value;
}

std::size_t MshScanner::count(const char* what) {
  const long value = whole(what);
  // Each thing counted takes two bytes at least.
  if (value < 0 || static_cast<std::size_t>(value) > rest_.size() / 2)
    refuse(std::string(what) + " is more than the file holds: truncated?");
  return static_cast<std::size_t>(value);
}

std::string MshScanner::quoted() {
  skip_space();
  const auto end = rest_.find('"', 1);
  if (!rest_.starts_with('"') || end == std::string_view::npos) refuse("a name in quotes is needed");
  const std::string name(rest_.substr(1, end - 1));
  rest_.remove_prefix(end + 1);
  return name;
}

}  // namespace rebound
