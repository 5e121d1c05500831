#include "comparisons/app/human_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rebound {
namespace {

using Characters = std::vector<std::string>;  // one code point each

constexpr std::size_t narrowest_gap = 2;
constexpr std::size_t narrowest_window = 20;  // below it nothing can be read anyway

Characters characters_of(const std::string& line) {
  Characters characters;
  for (const char byte : line) {
    const bool goes_on = (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
    if (goes_on && !characters.empty())
      characters.back() += byte;
    else
      characters.emplace_back(1, byte);
  }
  return characters;
}

std::string text_of(const Characters& characters, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text += characters[i];
  return text;
}

/// Where the first character that is no blank stands.
std::size_t indent_of(const Characters& line) {
  const auto first = std::find_if(line.begin(), line.end(), [](const auto& c) { return c != " "; });
  return static_cast<std::size_t>(first - line.begin());
}

/// Columns are parted by two blanks at least; words of a sentence by one.
bool has_columns(const Characters& line) {
  for (std::size_t i = indent_of(line) + 1; i < line.size(); ++i)
    if (line[i] == " " && line[i - 1] == " ") return true;
  return false;
}

std::size_t longest_of(const std::vector<Characters*>& rows) {
  std::size_t longest = 0;
  for (const Characters* row : rows) longest = std::max(longest, row->size());
  return longest;
}

struct Gap {
  std::size_t begin = 0;
  std::size_t size = 0;
};

/// Columns that are blank in every row, between columns that are not, right ones first.
std::vector<Gap> gaps_of(const std::vector<Characters*>& rows) {
  std::vector<bool> used(longest_of(rows), false);
  for (const Characters* row : rows)
    for (std::size_t i = 0; i < row->size(); ++i)
      if ((*row)[i] != " ") used[i] = true;
  std::vector<Gap> gaps;
  const auto first = std::find(used.begin(), used.end(), true) - used.begin();
  for (auto i = static_cast<std::size_t>(first); i < used.size(); ++i) {
    if (used[i]) continue;
    if (gaps.empty() || gaps.back().begin + gaps.back().size != i) gaps.push_back({i, 0});
    ++gaps.back().size;
  }
  std::reverse(gaps.begin(), gaps.end());
  return gaps;
}

/// Takes blanks out of the widest gap, one by one, until the rows fit or no gap is wide.
void narrow(const std::vector<Characters*>& rows, std::size_t width) {
  std::vector<Gap> gaps = gaps_of(rows);
  const std::vector<Gap> before = gaps;
  for (std::size_t length = longest_of(rows); length > width; --length) {
    const auto widest = std::max_element(
        gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.size < b.size; });
    if (widest == gaps.end() || widest->size <= narrowest_gap) break;
    --widest->size;
  }
  for (std::size_t g = 0; g < gaps.size(); ++g)
    for (Characters* row : rows) {
      const std::size_t end = std::min(row->size(), before[g].begin + before[g].size);
      const std::size_t begin = gaps[g].begin + gaps[g].size;
      if (begin < end)
        row->erase(row->begin() + static_cast<long>(begin), row->begin() + static_cast<long>(end));
    }
}

/// Where the last column of a line begins that does so in the window's left half.
std::size_t hanging_indent(const Characters& line, std::size_t width) {
  std::size_t indent = indent_of(line);
  for (std::size_t i = indent + narrowest_gap; i < std::min(line.size(), width / 2); ++i)
    if (line[i] != " " && line[i - 1] == " " && line[i - 2] == " ") indent = i;
  return indent;
}

/// A line as several, broken between words.
std::string wrapped(Characters line, std::size_t width) {
  std::string text;
  const std::size_t indent = hanging_indent(line, width);
  while (line.size() > width) {
    std::size_t at = width;
    while (at > indent && line[at] != " ") --at;
    if (at == indent)  // a word longer than the window: up to its end
      at = static_cast<std::size_t>(
          std::find(line.begin() + static_cast<long>(width), line.end(), " ") - line.begin());
    std::size_t end = at;
    while (end > 0 && line[end - 1] == " ") --end;
    text += text_of(line, 0, end) + "\n";
    while (at < line.size() && line[at] == " ") ++at;
    Characters rest(indent, " ");
    rest.insert(rest.end(), line.begin() + static_cast<long>(at), line.end());
    if (at == line.size()) return text;
    line = std::move(rest);
  }
  return text + text_of(line, 0, line.size()) + "\n";
}

struct Fold {
  std::vector<std::size_t> starts;  ///< columns at which rows go on below
  std::size_t indent = 0;           ///< of what goes on
};

/// Where rows that are still too long can all go on below, so that columns stay columns. Empty
/// where they are no table, but names with a sentence beside them, or where one column is too wide.
Fold fold_of(const std::vector<Characters*>& rows, std::size_t width) {
  constexpr std::size_t gaps_of_a_table = 3;
  std::vector<Gap> gaps = gaps_of(rows);
  if (gaps.size() < gaps_of_a_table || longest_of(rows) <= width) return {};
  std::reverse(gaps.begin(), gaps.end());
  Fold fold;
  for (const Gap& gap : gaps)
    if (gap.begin + gap.size <= width / 3) fold.indent = gap.begin + gap.size;
  gaps.push_back({longest_of(rows), 0});
  std::size_t start = 0, room = width, last_fitting = 0;
  for (const Gap& gap : gaps) {
    if (gap.begin - start > room) {
      if (last_fitting == start) return {};
      fold.starts.push_back(last_fitting);
      start = last_fitting;
      room = width - fold.indent;
      if (gap.begin - start > room) return {};
    }
    last_fitting = gap.begin + gap.size;
  }
  return fold;
}

std::string folded(const Characters& row, const Fold& fold) {
  std::string text;
  std::size_t begin = 0;
  for (std::size_t part = 0; part <= fold.starts.size() && begin < row.size(); ++part) {
    const std::size_t next = part < fold.starts.size() ? fold.starts[part] : row.size();
    std::size_t end = std::min(next, row.size());
    while (end > begin && row[end - 1] == " ") --end;
    if (part > 0 && end > begin) text += std::string(fold.indent, ' ');
    if (end > begin) text += text_of(row, begin, end) + "\n";
    begin = next;
  }
  return text;
}

}  // namespace

std::string duration_text(double seconds) {
  constexpr double minute = 60.0, hour = 60.0 * minute, day = 24.0 * hour;
  if (!std::isfinite(seconds)) return "an unknown time";
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  const auto in_two = [&](double large, const char* large_name, double small,
                          const char* small_name) {
    const auto all = std::llround(seconds / small);
    const auto in_large = std::llround(large / small);
    const std::string rest =
        all % in_large ? fmt::format(" {} {}", all % in_large, small_name) : "";
    return fmt::format("{} {}{}", all / in_large, large_name, rest);
  };
  if (std::round(seconds) < minute) return fmt::format("{:.0f} s", seconds);
  if (std::round(seconds) < hour) return in_two(minute, "min", 1.0, "s");
  if (std::round(seconds / minute) * minute < day) return in_two(hour, "h", minute, "min");
  return in_two(day, "d", hour, "h");
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  constexpr std::size_t ungrouped = 4, group = 3;
  if (text.size() <= ungrouped) return text;
  for (std::size_t at = text.size() - group;
       at > 0 && at<text.size(); at = at> group ? at - group : 0)
    text.insert(at, 1, ' ');
  return text;
}

std::string rate_text(double per_second) {
  const double percent = 100.0 * per_second;
  if (percent >= 1.0) return fmt::format("{:.2g} %/s", percent);
  if (60.0 * percent >= 1.0) return fmt::format("{:.2g} %/min", 60.0 * percent);
  return fmt::format("{:.2g} %/h", 3600.0 * percent);
}

std::string fitted_to_width(const std::string& text, std::size_t width) {
  if (width < narrowest_window) return text;
  std::string fitted;
  std::vector<Characters> block;
  const auto flush = [&] {
    std::vector<Characters*> rows;
    for (Characters& line : block)
      if (has_columns(line)) rows.push_back(&line);
    narrow(rows, width);
    const Fold fold = fold_of(rows, width);
    for (const Characters& line : block)
      fitted +=
          has_columns(line) && !fold.starts.empty() ? folded(line, fold) : wrapped(line, width);
    block.clear();
  };
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (!line.empty()) {
      block.push_back(characters_of(line));
      continue;
    }
    flush();
    fitted += "\n";
  }
  flush();
  if (!text.ends_with('\n') && fitted.ends_with('\n')) fitted.pop_back();
  return fitted;
}

}  // namespace rebound
