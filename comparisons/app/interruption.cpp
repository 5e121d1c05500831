#include "comparisons/app/interruption.hpp"

#include <atomic>
#include <csignal>

namespace rebound {
namespace {

std::atomic<bool> asked_to_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // legal in a signal handler

extern "C" void ask_to_stop(int) {
  asked_to_stop.store(true);
}

}  // namespace

void watch_for_interruption() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second signal acts by default
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that may not grow further is an error of the write, not an end.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() {
  return asked_to_stop.load();
}

}  // namespace rebound
