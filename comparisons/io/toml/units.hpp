#pragma once

#include <string>
#include <string_view>

#include "lumped/problem/dimension.hpp"

namespace rebound {

/// A unit as written by a user: 10^power_of_ten times the SI unit of `dimension`.
struct Unit {
  double power_of_ten = 0.0;  ///< fractional for mm^1.5
  Dimension dimension;

  double factor() const;  ///< size in SI
};

/// Reads a unit such as "mm", "N/m^1.5", "N.s/m^2.5" or "kg.m/s^2".
///
///   unit    = product { "/" product }        every product after a "/" divides
///   product = atom { "." atom }
///   atom    = [prefix] symbol [ "^" number ]
///   symbol  = m s g N Pa Hz J,   prefix = k M G c m u µ n
///
/// Empty text is the dimensionless unit.
/// Errors: Error(bad_input) naming the part that is not understood.
Unit parse_unit(std::string_view text);

/// Reads "33.1 mm" into SI. The decimal number and a whole power of ten are
/// converted in one correctly rounded step, so that "33.1 mm" and "0.0331 m"
/// give the same bits -> test UnitsTest.PrefixAndExponentGiveTheSameBits.
///
/// Errors: Error(bad_input) for a missing unit, another dimension, a decimal
/// comma, or a number that is not finite.
double parse_quantity(std::string_view text, const Dimension& expected);

/// Writes an SI value in `unit` with the fewest digits that read back to the
/// same bits; falls back to the SI unit where no such text exists.
std::string format_quantity(double value, std::string_view unit);

/// Shortest text of a number that reads back to the same bits.
std::string format_number(double value);

}  // namespace rebound
