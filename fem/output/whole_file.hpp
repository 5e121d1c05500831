#pragma once

#include <filesystem>
#include <string_view>

namespace rebound::fem {

/// Writes a file so that a reader sees the old one or the whole new one: temporary
/// name in the same folder, sync, rename.
/// Errors: Error(input_output_failed) with the file and the system's reason; the
///         temporary file is then removed.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

}  // namespace rebound::fem
