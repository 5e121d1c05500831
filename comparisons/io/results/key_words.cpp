#include "comparisons/io/results/key_words.hpp"

#include <array>
#include <utility>

#include "comparisons/io/text.hpp"

namespace rebound {

KeyWords words_of_key(const std::string& key) {
  // Longer endings first: a speed ends in that of a time.
  constexpr std::array<std::pair<const char*, const char*>, 5> units{
      {{"_m_s", "m/s"}, {"_N_s", "N.s"}, {"_N", "N"}, {"_m", "m"}, {"_s", "s"}}};
  KeyWords words{key, ""};
  for (const auto& [ending, unit] : units)
    if (key.ends_with(ending)) {
      words = {key.substr(0, key.size() - std::string(ending).size()), unit};
      break;
    }
  words.quantity = with_blanks(words.quantity);
  return words;
}

std::string behind_number(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " " + unit;
}

}  // namespace rebound
