#include "comparisons/models/parallel/in_parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lumped/problem/error.hpp"

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
  EXPECT_LE(begun, worker_threads());
}

// Both are under way before either fails, and the one or the other fails first.
TEST(InParallelTest, TheSmallestIndexThatFailsIsReported) {
  using namespace std::chrono_literals;
  for (const std::size_t slower : {1, 2, 1, 2}) {
    std::atomic<int> begun = 0;
    const auto both = [&] { return begun == 2 || worker_threads() < 2; };
    try {
      in_parallel(8, [&](std::size_t i) {
        if (i != 1 && i != 2) return;
        ++begun;
        for (int waited = 0; !both() && waited < 1000; ++waited) std::this_thread::sleep_for(1ms);
        if (i == slower) std::this_thread::sleep_for(20ms);
        throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "no error came through";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "1");
    }
  }
}

TEST(InParallelTest, NestedCallsEndAndDoEveryPieceOnce) {
  std::vector<std::vector<int>> done(20, std::vector<int>(20, 0));
  in_parallel(done.size(), [&](std::size_t i) {
    in_parallel(done[i].size(), [&](std::size_t k) { ++done[i][k]; });
  });
  for (const auto& row : done)
    for (const int count : row) EXPECT_EQ(count, 1);
}

TEST(InParallelTest, ALimitHoldsWhileItLives) {
  const int all = worker_threads();
  {
    const ThreadLimit one(1);
    EXPECT_EQ(worker_threads(), 1);
    const auto caller = std::this_thread::get_id();
    in_parallel(100, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
  }
  EXPECT_EQ(worker_threads(), all);
  EXPECT_THROW(ThreadLimit(0), Error);
  EXPECT_THROW(ThreadLimit(1025), Error);
}

}  // namespace
}  // namespace rebound
