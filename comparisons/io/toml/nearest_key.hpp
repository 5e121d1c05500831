#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rebound {

/// The candidate a typing error most likely meant, or empty: the smallest
/// number of inserted, dropped, changed or swapped letters, at most a third
/// of the word's length.
std::string nearest_key(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace rebound
