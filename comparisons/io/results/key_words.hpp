#pragma once

#include <string>

namespace rebound {

/// A key of a result for a reader: "peak_force_N" is the peak force in N.
struct KeyWords {
  std::string quantity;
  std::string unit;  ///< empty: a pure number
};

/// The unit is the ending of the key: _N, _m, _s, _m_s, _N_s; any other key is a pure number.
KeyWords words_of_key(const std::string& key);

/// " N" behind a number, nothing behind a pure one ("" or "1").
std::string behind_number(const std::string& unit);

}  // namespace rebound
