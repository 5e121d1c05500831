#pragma once

#include <time.h>

namespace rebound {

/// Processor time [s]: what a busy machine does not lengthen.
inline double processor_time(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
inline double thread_time() {
  return processor_time(CLOCK_THREAD_CPUTIME_ID);
}
inline double process_time() {
  return processor_time(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace rebound
