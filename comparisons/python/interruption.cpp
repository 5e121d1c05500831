#include <atomic>
#include <chrono>
#include <future>
#include <optional>

#include "comparisons/python/binding.hpp"

namespace rebound::python {

void run_interruptibly(const std::function<void(const RunControl&)>& work) {
  constexpr auto between_looks = std::chrono::milliseconds(50);
  std::atomic<bool> asked_to_stop{false};
  std::optional<py::error_already_set> signal;
  std::future<void> done;
  {
    const py::gil_scoped_release without_lock;
    done = std::async(std::launch::async, [&] {
      work({.interrupted = [&] { return asked_to_stop.load(); }, .progress = {}});
    });
    while (done.wait_for(between_looks) != std::future_status::ready) {
      if (asked_to_stop.load()) continue;
      const py::gil_scoped_acquire with_lock;
      if (PyErr_CheckSignals() == 0) continue;
      signal.emplace();
      asked_to_stop.store(true);
    }
  }
  if (!signal) return done.get();
  try {
    done.get();
  } catch (const std::exception&) {
    // That the work was interrupted is known; the signal's own exception is what Python expects.
  }
  throw py::error_already_set(*signal);
}

}  // namespace rebound::python
