#include "lumped/problem/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int reason) {
  throw Error(ExitCode::input_output_failed, std::string(what) + ": " + std::strerror(reason),
              {.file = path.string()});
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  int close() {
    const int status = ::close(number_);
    number_ = -1;
    return status;
  }

 private:
  int number_;
};

/// Returns 0 or the system's reason.
int write_and_sync(const std::string& name, std::string_view text) {
  Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file.number() < 0) return errno;
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file.number()) != 0) return errno;
  return file.close() == 0 ? 0 : errno;
}

}  // namespace

void write_file_atomically(const std::filesystem::path& file, std::string_view text) {
  // Two writers get two names; the last rename wins with a whole file.
  const std::string temporary = file.string() + ".partial-" + std::to_string(::getpid());
  int reason = write_and_sync(temporary, text);
  if (reason == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(temporary.c_str());
    fail(file, "the file cannot be written", reason);
  }
  const std::filesystem::path parent = file.parent_path();
  const Descriptor folder(
      ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.number() >= 0) ::fsync(folder.number());
}

void make_writable_folder(const std::filesystem::path& folder) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  if (status) fail(folder, "the output folder cannot be made", status.value());
  if (!std::filesystem::is_directory(folder))
    fail(folder, "the output folder cannot be made", ENOTDIR);
  const std::string probe = folder.string() + "/.writable-" + std::to_string(::getpid());
  const int reason = write_and_sync(probe, "");
  ::unlink(probe.c_str());
  if (reason != 0) fail(folder, "the output folder cannot be written to", reason);
}

}  // namespace rebound
