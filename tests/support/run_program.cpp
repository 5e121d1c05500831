#include "tests/support/run_program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace rebound::testing {
namespace {

constexpr uid_t nobody = 65534;

/// Runs in the child; only returns by exiting.
[[noreturn]] void become(const Invocation& run, int program, int output, int errors) {
  if (::chdir(run.folder.c_str()) != 0) ::_exit(126);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  for (const std::string& variable : run.environment) ::putenv(const_cast<char*>(variable.c_str()));
  if (run.largest_file > 0) {
    const auto bytes = static_cast<rlim_t>(run.largest_file);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (run.privileges == Privileges::drop && ::geteuid() == 0)
    if (::setgid(nobody) != 0 || ::setuid(nobody) != 0) ::_exit(126);
  std::vector<char*> arguments;
  for (const std::string& argument : run.arguments)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  // By descriptor: an unprivileged user may not see the build folder.
  ::fexecve(program, arguments.data(), environ);
  ::_exit(127);
}

int temporary_file() {
  std::string pattern = (std::filesystem::temp_directory_path() / "output-XXXXXX").string();
  const int file = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (file < 0) throw std::runtime_error("no temporary file can be made");
  ::unlink(pattern.c_str());
  return file;
}

std::string drain(int file) {
  std::string text;
  std::array<char, 65536> buffer{};
  ::lseek(file, 0, SEEK_SET);
  for (ssize_t n = 0; (n = ::read(file, buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  ::close(file);
  return text;
}

}  // namespace

Outcome run_program(const Invocation& run) {
  const int program = ::open(run.arguments.front().c_str(), O_RDONLY | O_CLOEXEC);
  if (program < 0) throw std::runtime_error("cannot open " + run.arguments.front());
  const int output = temporary_file();
  const int errors = temporary_file();
  const pid_t child = ::fork();
  if (child == 0) become(run, program, output, errors);
  if (run.interrupt_after_ms > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(run.interrupt_after_ms));
    ::kill(child, SIGINT);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(program);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), drain(output),
          drain(errors)};
}

}  // namespace rebound::testing
