#pragma once

#include <filesystem>
#include <string_view>

namespace rebound {

/// Writes a file so that a reader sees the old one or the whole new one,
/// whatever happens: temporary name in the same folder, sync, rename, sync of
/// the folder.
///
/// Errors: Error(input_output_failed) with the file and the system's reason;
/// the temporary file is then removed.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);

/// Makes a folder and proves that files can be written there, so that a long
/// run does not end in a refusal.
/// Errors: Error(input_output_failed).
void make_writable_folder(const std::filesystem::path& folder);

}  // namespace rebound
