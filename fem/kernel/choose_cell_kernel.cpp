#include <cstdlib>

#include "fem/kernel/cell_observer.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {

extern const CellKernel cell_kernel_baseline;
#ifdef __x86_64__
extern const CellKernel cell_kernel_avx2;
extern const CellKernel cell_kernel_avx512;
#endif

extern const CellObserver cell_observer_baseline;
#ifdef __x86_64__
extern const CellObserver cell_observer_avx2;
extern const CellObserver cell_observer_avx512;
#endif

const CellKernel* find_cell_kernel(const std::string& name) {
  if (name == "baseline") return &cell_kernel_baseline;
#ifdef __x86_64__
  if (name == "avx2" && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return &cell_kernel_avx2;
  if (name == "avx512" && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("fma"))
    return &cell_kernel_avx512;
#endif
  return nullptr;
}

const CellKernel& choose_cell_kernel() {
  if (const char* asked = std::getenv("REBOUND_KERNEL"); asked && *asked) {
    if (const CellKernel* kernel = find_cell_kernel(asked)) return *kernel;
    throw Error(ExitCode::bad_input, "REBOUND_KERNEL: this machine has no such kernel",
                {.key = "REBOUND_KERNEL", .value = asked, .allowed = "baseline, avx2, avx512"});
  }
  for (const char* name : {"avx512", "avx2"})
    if (const CellKernel* kernel = find_cell_kernel(name)) return *kernel;
  return cell_kernel_baseline;
}

const CellObserver& observer_of([[maybe_unused]] const CellKernel& kernel) {
#ifdef __x86_64__
  if (&kernel == &cell_kernel_avx2) return cell_observer_avx2;
  if (&kernel == &cell_kernel_avx512) return cell_observer_avx512;
#endif
  return cell_observer_baseline;
}

}  // namespace rebound::fem
