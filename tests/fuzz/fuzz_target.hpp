#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "lumped/problem/error.hpp"

/// What the fuzz targets share: bytes as a file, and what may come of them.
namespace rebound::fuzz {

/// The bytes as a file of this process, overwritten by the next ones.
inline std::filesystem::path as_file(const std::uint8_t* data, std::size_t size,
                                     const char* extension) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("rebound-fuzz-" + std::to_string(::getpid()) + extension);
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (!out) std::abort();
  if (size > 0 && std::fwrite(data, 1, size, out) != size) std::abort();
  std::fclose(out);
  return file;
}

/// Any bytes are read or refused by an Error of a reader; whatever else is thrown is a finding.
template <class Read>
int refused_or_read(Read&& read) {
  try {
    read();
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input && error.code() != ExitCode::input_output_failed &&
        error.code() != ExitCode::corrupt_store)
      std::abort();
  }
  return 0;
}

}  // namespace rebound::fuzz
