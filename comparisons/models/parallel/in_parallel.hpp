#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace rebound {

/// Does `work(i)` for every i below `count`, in the order of i as threads come
/// free, and returns when all have ended. Work that writes to a place of its
/// own gives the same result whatever the threads do. Calls may be nested.
///
/// Errors: the error of the smallest i that threw; no i is begun after an
///         error -> test InParallelTest.AnErrorEndsIt.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

/// Threads that in_parallel() works with, the caller's own with them.
int worker_threads();

/// Holds in_parallel() to so many threads for as long as it lives; the
/// smallest of several holds. Without one: all processors of this process.
class ThreadLimit {
 public:
  /// Errors: Error(bad_input) below 1 or above 1024.
  explicit ThreadLimit(int threads);
  ~ThreadLimit();

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace rebound
