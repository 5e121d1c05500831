#pragma once

#include <string>

namespace rebound {

/// Prints to standard output what a person reads: fitted to the window where that is a terminal, as
/// it stands where it is a file or a pipe. Not for JSON, CSV and files in other formats.
void print_text(const std::string& text);

}  // namespace rebound
