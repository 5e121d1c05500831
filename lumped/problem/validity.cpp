#include "lumped/problem/validity.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::string six_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::string allowed_text(const Range& range, const std::string& unit, double unit_size) {
  const bool low = std::isfinite(range.lowest);
  const bool high = std::isfinite(range.highest);
  const std::string tail = unit.empty() ? "" : " " + unit;
  const std::string lowest = six_digits(range.lowest / unit_size);
  const std::string highest = six_digits(range.highest / unit_size);
  if (low && range.lowest == range.highest) return lowest + tail;
  const std::string below = range.highest_allowed ? "value <= " : "value < ";
  if (low && high) return lowest + (range.lowest_allowed ? " <= " : " < ") + below + highest + tail;
  if (low) return (range.lowest_allowed ? "value >= " : "value > ") + lowest + tail;
  if (high) return below + highest + tail;
  return unit.empty() ? "" : "a number of " + unit;
}

std::string KeyPath::text() const {
  std::string text = name;
  if (index >= 0) text += "[" + std::to_string(index) + "]";
  const std::string before = above ? above->text() : "";
  return before.empty() ? text : before + "." + text;
}

std::string KeyPath::of(const std::string& key) const {
  const std::string path = text();
  return path.empty() ? key : path + "." + key;
}

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string out_of_range_text(const std::string& reason) {
  return "the value is out of range" + (reason.empty() ? "" : ": " + reason);
}

void refuse_value(const std::string& key, double value, const std::string& allowed,
                  const std::string& reason) {
  throw Error(ExitCode::bad_input, out_of_range_text(reason),
              {.key = key, .value = number_text(value), .allowed = allowed});
}

}  // namespace rebound
