#include "comparisons/io/results/digest.hpp"

#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "lumped/problem/error.hpp"

namespace rebound {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * digest.size());
  for (const unsigned char byte : digest) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw Error(ExitCode::input_output_failed, "cannot be read", {.file = file.string()});
  return bytes.str();
}

std::string digest_of_folder(const std::filesystem::path& folder) {
  std::error_code status;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, status))
    if (entry.is_regular_file()) files.push_back(entry.path());
  if (status)
    throw Error(ExitCode::input_output_failed, "cannot be read: " + status.message(),
                {.file = folder.string()});
  std::sort(files.begin(), files.end());
  std::string all;
  for (const auto& file : files)
    all += file.lexically_relative(folder).string() + "\n" + sha256(bytes_of(file)) + "\n";
  return sha256(all);
}

}  // namespace rebound
