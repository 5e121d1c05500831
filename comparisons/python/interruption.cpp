#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "comparisons/python/binding.hpp"

namespace rebound::python {
namespace {

using Clock = std::chrono::steady_clock;

/// Phases that did not end when they were asked to; touched with Python's lock held.
std::vector<std::future<void>>& left_running() {
  static std::vector<std::future<void>> list;
  return list;
}

struct Task {
  std::atomic<bool> asked_to_stop{false};
  std::promise<void> done;
};

std::future<void> start(const std::shared_ptr<Task>& task, Work work) {
  std::future<void> done = task->done.get_future();
  std::thread([task, work = std::move(work)]() mutable {
    std::exception_ptr failure;
    try {
      work({.interrupted = [&] { return task->asked_to_stop.load(); }, .progress = {}});
    } catch (...) {
      failure = std::current_exception();
    }
    work = nullptr;  // what it owns is gone before anybody is told
    if (failure)
      task->done.set_exception(failure);
    else
      task->done.set_value();
  }).detach();
  return done;
}

}  // namespace

void run_interruptibly(Work work) {
  constexpr auto between_looks = std::chrono::milliseconds(20);
  constexpr auto patience = std::chrono::milliseconds(600);
  const auto task = std::make_shared<Task>();
  std::optional<py::error_already_set> signal;
  std::future<void> done;
  {
    const py::gil_scoped_release without_lock;
    done = start(task, std::move(work));
    auto asked = Clock::time_point::max();
    while (done.wait_for(between_looks) != std::future_status::ready) {
      if (signal && Clock::now() - asked > patience) break;
      if (signal) continue;
      const py::gil_scoped_acquire with_lock;
      if (PyErr_CheckSignals() == 0) continue;
      signal.emplace();
      task->asked_to_stop.store(true);
      asked = Clock::now();
    }
  }
  if (!signal) return done.get();
  left_running().push_back(std::move(done));
  throw py::error_already_set(*signal);
}

void declare_interruption(const py::module_&) {
  // A thread that still works must not see the process's data go.
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    std::vector<std::future<void>> all = std::move(left_running());
    const py::gil_scoped_release without_lock;
    for (const std::future<void>& one : all) one.wait();
  }));
}

}  // namespace rebound::python
