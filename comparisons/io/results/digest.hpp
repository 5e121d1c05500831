#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rebound {

/// SHA-256 as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The bytes of a file. Errors: Error(input_output_failed).
std::string bytes_of(const std::filesystem::path& file);

/// SHA-256 over names and bytes of all files in a folder and below it. Errors: as bytes_of().
std::string digest_of_folder(const std::filesystem::path& folder);

}  // namespace rebound
