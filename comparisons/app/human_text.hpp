#pragma once

#include <cstddef>
#include <string>

namespace rebound {

/// A time as one says it, in two units at most: "0.066 s", "45 s", "3 min 20 s", "2 h 5 min",
/// "4 d 7 h".
///
///   seconds   [s], not negative; what is not finite is "an unknown time"
std::string duration_text(double seconds);

/// A number of things; from five digits on in groups of three: "504", "4096", "12 400".
std::string count_text(std::size_t count);

/// How fast a share grows, in the shortest time in which it is at least one per cent:
/// "4.2 %/s", "1.3 %/min", "0.5 %/h".
///
///   per_second   share done in a second [1/s]
std::string rate_text(double per_second);

/// Text for a window of `width` characters. Of rows that lie together the gaps between columns are
/// narrowed to two blanks, as far as is needed, sentences between them left aside; a table
/// that is still too wide goes on below at one of its gaps, and a line that is
/// still too long goes on below, between words, under the last column that begins in the left half.
/// Text that fits, and a word that is longer than the window, stay as they are. Takes each code
/// point for one character wide.
std::string fitted_to_width(const std::string& text, std::size_t width);

}  // namespace rebound
