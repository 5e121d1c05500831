#include "fem/output/whole_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

/// 0 or the system's reason.
int write_and_sync(const std::string& name, std::string_view text) {
  errno = 0;
  std::FILE* file = std::fopen(name.c_str(), "wb");
  if (!file) return errno;
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                       std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
  const int reason = written ? 0 : errno;
  return std::fclose(file) == 0 || reason != 0 ? reason : errno;
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  const std::string temporary = file.string() + ".partial-" + std::to_string(::getpid());
  int reason = write_and_sync(temporary, text);
  if (reason == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) reason = errno;
  if (reason == 0) return;
  std::remove(temporary.c_str());
  throw Error(ExitCode::input_output_failed,
              std::string("the field file cannot be written: ") + std::strerror(reason),
              {.file = file.string()});
}

}  // namespace rebound::fem
