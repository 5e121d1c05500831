#pragma once

#include <vector>

#include "comparisons/studies/reproduce/row.hpp"

namespace rebound {

/// How closely a changed row has to meet its published number.
enum class Strictness {
  within_rounding,  ///< for some values of the other inputs within their rounding
  to_the_digit,     ///< with the other inputs as printed
};

/// The values of one input with which the row would follow.
///
///   { u : published ± half a digit meets [low(u), high(u)] },  input := u
///
/// Searched from 1/8 to 8 times the printed value: the signed gap between the
/// two intervals on a logarithmic grid, its sign changes then bisected. Finds
/// every interval, however narrow, whose gap changes sign across it.
/// Caution: a gap that touches zero and turns back between two grid points is
///          missed; grid spacing is 1.7 %.
/// Needs an input that is not zero.
std::vector<Interval> accepted_values(const DerivedRow& row, std::size_t input,
                                      Strictness strictness);

}  // namespace rebound
