#include "comparisons/io/toml/nearest_key.hpp"

#include <algorithm>

namespace rebound {
namespace {

/// Optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = d[i - 1][j - 1] + (a[i - 1] != b[j - 1] ? 1 : 0);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest_key(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_key = 64;  // nobody mistypes a key into a page of text
  if (word.size() > longest_key) return {};
  std::string nearest;
  std::size_t smallest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  constexpr std::size_t enough = 3;
  if (!nearest.empty() || word.size() < enough) return nearest;
  // A name that was cut short, "poisson" for "poisson_ratio", where one alone begins so.
  for (const std::string& candidate : candidates)
    if (candidate.starts_with(word)) {
      if (!nearest.empty()) return {};
      nearest = candidate;
    }
  return nearest;
}

}  // namespace rebound
