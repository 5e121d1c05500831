#include "comparisons/models/parallel/in_parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>

#include "lumped/problem/error.hpp"

#ifdef REBOUND_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace rebound {
namespace {

/// oneTBB is not built with the thread sanitizer, which therefore does not see that it hands work
/// to a thread and back. It is told so here, and this file is compiled without it, for the same
/// of the library's headers; what the work itself reads and writes is watched as ever.
struct HandOver {
  void give() {
#ifdef REBOUND_THREAD_SANITIZER
    __tsan_release(this);
#endif
  }
  void take() {
#ifdef REBOUND_THREAD_SANITIZER
    __tsan_acquire(this);
#endif
  }
};
HandOver to_threads, to_caller;

}  // namespace

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex guard;
  std::exception_ptr failure;
  std::size_t failed = count;
  const auto take_in_order = [&] {
    to_threads.take();
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (i < failed) {
          failed = i;
          failure = std::current_exception();
        }
        next = count;
      }
    }
    to_caller.give();
  };
  const std::size_t workers = std::min<std::size_t>(count, worker_threads());
  to_threads.give();
  // Isolated: a thread that waits here takes up no piece of an outer call.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        std::size_t{0}, workers, [&](std::size_t) { take_in_order(); }, tbb::simple_partitioner());
  });
  to_caller.take();
  if (failure) std::rethrow_exception(failure);
}

int worker_threads() {
  const auto allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min<std::size_t>(allowed, tbb::this_task_arena::max_concurrency()));
}

/// Made where it stays: oneTBB knows the control by its address.
struct ThreadLimit::Control {
  explicit Control(std::size_t threads)
      : parallelism(tbb::global_control::max_allowed_parallelism, threads) {}
  tbb::global_control parallelism;
};

ThreadLimit::ThreadLimit(int threads) {
  constexpr int most = 1024;
  if (threads < 1 || threads > most)
    throw Error(
        ExitCode::bad_input, "out of range",
        {.key = "--threads", .value = std::to_string(threads), .allowed = "1 to 1024 threads"});
  control_ = std::make_unique<Control>(static_cast<std::size_t>(threads));
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace rebound
