#include "comparisons/parallel/in_parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace rebound {
namespace {

TEST(InParallelTest, EveryPieceIsDoneOnce) {
  std::vector<int> done(1000, 0);
  in_parallel(done.size(), [&](std::size_t i) { ++done[i]; });
  for (const int count : done) EXPECT_EQ(count, 1);
  in_parallel(0, [](std::size_t) { FAIL(); });
}

TEST(InParallelTest, AnErrorEndsIt) {
  std::atomic<int> begun = 0;
  try {
    in_parallel(100000, [&](std::size_t i) {
      ++begun;
      throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "no error came through";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "0");
  }
  EXPECT_LE(begun, worker_threads);
}

}  // namespace
}  // namespace rebound
