#include "comparisons/app/interruption.hpp"

#include <time.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

namespace rebound {
namespace {

// All that the handlers touch is lock-free or a plain system call that signals may make.
std::atomic<bool> asked_to_stop{false};
std::atomic<bool> heard{false};   ///< somebody has looked since
std::atomic<bool> warned{false};  ///< the reader has been told to wait
std::atomic<long> last_look{-1};  ///< when somebody last looked [s]; -1: never
std::atomic<bool> json_wanted{false};
timer_t patience{};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free);

constexpr long recently = 4;  // a phase that looks does so more often [s]

long now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

void say(int stream, std::string_view text) {
  [[maybe_unused]] const auto written = ::write(stream, text.data(), text.size());
}

void wait_for(long seconds, long nanoseconds) {
  itimerspec once{};
  once.it_value = {.tv_sec = seconds, .tv_nsec = nanoseconds};
  ::timer_settime(patience, 0, &once, nullptr);
}

extern "C" void ask_to_stop(int) {
  asked_to_stop.store(true);
  wait_for(0, 700'000'000);
}

/// Nobody has looked: a phase that keeps nothing is ended, one that looks now and then gets a
/// little longer. The reader has an answer within a second in either case.
extern "C" void end_of_patience(int) {
  const long look = last_look.load();
  const bool stopping = heard.load();
  if (!warned.exchange(true) && (stopping || (look >= 0 && now() - look <= recently))) {
    say(STDERR_FILENO, "\nrebound: stopping; what is complete is kept\n");
    if (!stopping) wait_for(recently, 0);
    return;
  }
  if (stopping) return;
  if (json_wanted.load())
    say(STDOUT_FILENO,
        "{\"schema\":1,\"error\":{\"code\":130,\"message\":\"interrupted; what was stored is "
        "kept\",\"file\":null,\"line\":null,\"key\":null,\"value\":null,\"allowed\":null}}\n");
  else
    say(STDERR_FILENO, "\nrebound: interrupted; what was stored is kept\n");
  ::_exit(130);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void watch_for_interruption(OutputFormat format) {
  json_wanted.store(format == OutputFormat::json);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  ::timer_create(CLOCK_MONOTONIC, &event, &patience);
  handle(SIGALRM, end_of_patience, SA_RESTART);
  constexpr int once = static_cast<int>(SA_RESETHAND);  // the second signal acts by default
  handle(SIGINT, ask_to_stop, once);
  handle(SIGTERM, ask_to_stop, once);
  // A file that may not grow further is an error of the write, not an end.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() {
  last_look.store(now());
  if (!asked_to_stop.load()) return false;
  heard.store(true);
  return true;
}

}  // namespace rebound
