#include "comparisons/report/write_report.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "comparisons/report/check.hpp"
#include "comparisons/report/json.hpp"
#include "comparisons/report/page.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw Error(ExitCode::input_output_failed,
              "cannot write the report " + file.string() + ": " +
                  std::generic_category().message(error),
              {.file = file.string()});
}

/// Writes all of `content`, synced; 0, or the errno of what failed.
int write_all(int descriptor, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::write(descriptor, content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return ::fsync(descriptor) == 0 ? 0 : errno;
}

void replace_file(const std::filesystem::path& file, const std::string& content) {
  std::error_code made;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), made);
  if (made) fail(file, made.value());

  const std::filesystem::path temporary =
      file.string() + ".part-" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file, errno);
  int error = write_all(descriptor, content);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(file, error);
  }
}

}  // namespace

void write_report(const Report& report, const std::filesystem::path& file) {
  check_report(report);
  replace_file(file, page_html(report.title, report_json(report)));
}

}  // namespace rebound::report
