#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "comparisons/io/dataset/guess_dataset.hpp"

namespace rebound {
namespace {

std::string lower(std::string text) {
  for (char& sign : text) sign = static_cast<char>(std::tolower(static_cast<unsigned char>(sign)));
  return text;
}

/// Words of a name: "rebound_mean" is rebound, mean.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char sign : lower(name)) {
    if (std::isalnum(static_cast<unsigned char>(sign)))
      words.back() += sign;
    else if (!words.back().empty())
      words.emplace_back();
  }
  return words;
}

bool has_any(const std::vector<std::string>& words, const std::vector<std::string>& known) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(known.begin(), known.end(), word) != known.end();
  });
}

const std::vector<std::string> back_words{"rebound", "outbound", "out",     "after", "exit",
                                          "return",  "bounce",   "bounced", "v1",    "vout"};

/// The key that a column without "sd" and the like would hold; empty: none.
std::string key_of(const std::vector<std::string>& words, const std::optional<Dimension>& unit,
                   bool is_number) {
  const bool back = has_any(words, back_words);
  const auto is = [&](const Dimension& dimension) {
    return unit && same_dimension(*unit, dimension);
  };
  if (!is_number) return has_any(words, {"file", "trace", "record"}) ? "trace" : "";
  if (is(dimension::speed)) return back ? "rebound_speed" : "speed";
  if (is(dimension::length)) {
    if (has_any(words, {"gate", "gates"})) return "gate_distance";
    if (has_any(words, {"deflection", "compression"})) return "peak_deflection";
    if (back) return "rebound_height";
    return has_any(words, {"drop", "height", "h"}) ? "drop_height" : "";
  }
  if (is(dimension::time)) {
    if (has_any(words, {"gate", "gates"})) return back ? "rebound_gate_time" : "gate_time";
    if (has_any(words, {"contact"})) return "contact_time";
    if (has_any(words, {"flight"}) || has_any(words, {"between"}))
      return has_any(words, {"next", "second", "2"}) ? "next_flight_time" : "flight_time";
    return "";
  }
  if (is(dimension::force)) return "peak_force";
  if (has_any(words, {"restitution", "cor", "e"})) return "restitution";
  if (has_any(words, {"repeats", "n", "count"})) return "repeats";
  return "";
}

}  // namespace

GuessedColumns guess_shot_columns(const TablePreview& preview) {
  GuessedColumns guessed;
  for (std::size_t i = 0; i < preview.headings.size(); ++i) {
    const ColumnHeading& heading = preview.headings[i];
    const std::vector<std::string> words = words_of(heading.name);
    if (guessed.ball < 0 && has_any(words, {"ball", "sample", "specimen", "core"})) {
      guessed.ball = static_cast<int>(i);
      continue;
    }
    std::optional<Dimension> unit;
    if (const auto found = find_unit(heading.unit)) unit = found->dimension;
    std::string key = key_of(words, unit, preview.is_number[i]);
    const bool error =
        has_any(words, {"sd", "std", "sigma", "uncertainty", "err", "error", "u", "se", "stdev"});
    if (!key.empty() && error) key += "_uncertainty";
    if (key.empty() || guessed.by_key.contains(key))
      guessed.remarks.push_back(fmt::format("{}: {}", heading.text,
                                            !key.empty() ? "a second " + key
                                            : preview.is_number[i] && !unit
                                                ? "states no unit that is known, or no known name"
                                                : "no known name"));
    else
      guessed.by_key[key] = i;
  }
  // An uncertainty alone is none.
  std::erase_if(guessed.by_key, [&](const auto& entry) {
    constexpr std::string_view suffix = "_uncertainty";
    const std::string& key = entry.first;
    return key.ends_with(suffix) &&
           !guessed.by_key.contains(key.substr(0, key.size() - suffix.size()));
  });
  return guessed;
}

}  // namespace rebound
