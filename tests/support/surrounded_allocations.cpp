// Linked into a test program, this surrounds every aligned allocation (the arrays of the FE kernels
// among them) by numbers that are none, and fills it with the same. What is read beside an array,
// or before it is written, then shows as NaN in the result, on each instruction set and in each
// run. An ordinary heap holds harmless zeros there most of the time. The address sanitizer sees
// reads and writes beside an array itself, and is left to its own allocations.
#if !defined(__SANITIZE_ADDRESS__)

#include <cstdlib>
#include <cstring>
#include <new>

namespace {

constexpr std::size_t around = 4096;  // bytes on either side; a multiple of every alignment asked
constexpr int no_number = 0xff;       // of each byte: a double of these is NaN

}  // namespace

void* operator new(std::size_t size, std::align_val_t alignment) {
  void* whole = nullptr;
  if (static_cast<std::size_t>(alignment) > around ||
      ::posix_memalign(&whole, around, size + 2 * around) != 0)
    throw std::bad_alloc();
  std::memset(whole, no_number, size + 2 * around);
  return static_cast<char*>(whole) + around;
}

void operator delete(void* at, std::align_val_t) noexcept {
  if (at) std::free(static_cast<char*>(at) - around);
}
void operator delete(void* at, std::size_t, std::align_val_t alignment) noexcept {
  operator delete(at, alignment);
}

#endif
