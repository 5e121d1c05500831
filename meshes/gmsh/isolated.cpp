#include "meshes/gmsh/isolated.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <optional>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/mesh_bytes.hpp"

namespace rebound {
namespace {

void write_all(int to, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t part = ::write(to, bytes.data() + done, bytes.size() - done);
    if (part < 0 && errno == EINTR) continue;
    if (part <= 0) ::_exit(1);
    done += static_cast<std::size_t>(part);
  }
}

void limit(int what, double most) {
  const rlimit both{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(static_cast<__rlimit_resource>(what), &both);
}

rlim_t whole_seconds(const Isolation& limits) {
  return static_cast<rlim_t>(std::ceil(limits.seconds));
}

double mapped_memory() {
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void withdraw(pid_t parent, const Isolation& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) ::_exit(1);
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  std::signal(SIGXFSZ, SIG_IGN);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {0, 1, 2}) ::dup2(nothing, stream);
  limit(RLIMIT_CORE, 0.0);
  if (limits.files == Isolation::Files::none) limit(RLIMIT_FSIZE, 0.0);
  limit(RLIMIT_AS, mapped_memory() + limits.memory);
  // Of the soft limit alone there is a signal that says so.
  const rlimit time{whole_seconds(limits), RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &time);
}

/// "+" and the result, or "-" and the error.
std::string outcome_of(const std::function<std::string()>& work, const std::string& program) {
  try {
    return "+" + work();
  } catch (const Error& error) {
    return "-" + bytes_of(error);
  } catch (const std::string& reason) {  // what Gmsh 4.8 throws
    return "-" + bytes_of(Error(ExitCode::bad_input, program + ": " + reason));
  } catch (const std::bad_alloc&) {
    return "-" + bytes_of(Error(ExitCode::bad_input,
                                "it needs more memory than a file of its size can: damaged?"));
  } catch (const std::exception& error) {
    return "-" + bytes_of(Error(ExitCode::bad_input, program + ": " + error.what()));
  } catch (...) {
    return "-" + bytes_of(Error(ExitCode::bad_input, program + " gave up without a reason"));
  }
}

/// A process that is gone when this object is.
class Child {
 public:
  Child(pid_t id, int pipe) : id_(id), pipe_(pipe) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    ::close(pipe_);
    if (id_ == 0) return;
    ::kill(id_, SIGKILL);
    end();
  }
  int end() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = 0;
    return status;
  }
  /// Further bytes; empty at their end, nothing when there are none yet.
  std::optional<std::string> read(int wait_ms) const {
    pollfd ready{.fd = pipe_, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, wait_ms) <= 0) return std::nullopt;
    std::array<char, 1 << 16> buffer{};
    const ssize_t count = ::read(pipe_, buffer.data(), buffer.size());
    if (count < 0) return std::nullopt;
    return std::string(buffer.data(), static_cast<std::size_t>(count));
  }

 private:
  pid_t id_;
  int pipe_;
};

std::string bytes_from(Child& child, const std::string& program, const RunControl& control) {
  std::string bytes;
  for (;;) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted while " + program + " was at work");
    const auto more = child.read(100);
    if (!more) continue;
    if (more->empty()) return bytes;
    bytes += *more;
  }
}

}  // namespace

std::string isolated(const std::function<std::string()>& work, const Isolation& limits,
                     const RunControl& control) {
  const std::string program = limits.program;
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    throw Error(ExitCode::input_output_failed, std::string("no pipe: ") + std::strerror(errno));
  const pid_t parent = ::getpid();
  const pid_t id = ::fork();
  if (id == 0) {
    withdraw(parent, limits);
    write_all(pipe[1], outcome_of(work, limits.program));
    ::_exit(0);  // nothing of the parent's is flushed or destroyed here
  }
  ::close(pipe[1]);
  if (id < 0) {
    ::close(pipe[0]);
    throw Error(ExitCode::input_output_failed,
                "no process for " + program + ": " + std::strerror(errno));
  }
  Child child(id, pipe[0]);
  const std::string bytes = bytes_from(child, program, control);
  const int status = child.end();
  if (control.interrupted && control.interrupted())
    throw Error(ExitCode::interrupted, "interrupted while " + program + " was at work");
  // Ctrl-C goes to all processes of a terminal.
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM))
    throw Error(ExitCode::interrupted, "interrupted while " + program + " was at work");
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw Error(ExitCode::bad_input, program + " was at work on it for more than " +
                                         std::to_string(whole_seconds(limits)) +
                                         " s of processor time: damaged?");
  if (WIFSIGNALED(status))
    throw Error(ExitCode::bad_input,
                program + " crashed on it (" + strsignal(WTERMSIG(status)) + "): damaged?");
  if (bytes.empty() || WEXITSTATUS(status) != 0)
    throw Error(ExitCode::bad_input, program + " ended before it was done");
  if (bytes.front() == '-') throw error_of(bytes.substr(1));
  return bytes.substr(1);
}

}  // namespace rebound
