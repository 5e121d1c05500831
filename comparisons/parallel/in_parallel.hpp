#pragma once

#include <cstddef>
#include <functional>

namespace rebound {

/// Threads that work of one machine is shared over. Two whatever the machine:
/// an FE impact is bound by memory, and results must not depend on the count.
inline constexpr int worker_threads = 2;

/// Does `work(i)` for every i below `count`, in the order of i as threads come
/// free, and returns when all have ended. Work that writes to a place of its
/// own gives the same result whatever the threads do.
///
/// Errors: the error of the smallest i that threw; no i is begun after an
///         error -> test InParallelTest.AnErrorEndsIt.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace rebound
