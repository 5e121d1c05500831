#include "tests/fuzz/array_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return rebound::fuzz::array_file(data, size, ".mat");
}
