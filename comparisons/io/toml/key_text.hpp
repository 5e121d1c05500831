#pragma once

#include <string>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// The range of a number in the unit of its key: "0 < value <= 10 m",
/// "value > 0"; empty when any number will do.
std::string range_text(const Key& key);

/// What a key accepts, in words: its range and unit, or its list of names.
std::string allowed_text(const Key& key);

/// Names joined as "a | b | c".
std::string joined(const std::vector<std::string>& names);

}  // namespace rebound
