#include "comparisons/io/result_store/packed_trace.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::vector<TraceColumn> half_sine(std::size_t samples) {
  std::vector<TraceColumn> trace = {{"time_s", {}}, {"force_N", {}}};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(samples - 1);
    trace[0].values.push_back(2e-3 * t);
    trace[1].values.push_back(3000.0 * std::sin(3.14159 * t));
  }
  return trace;
}

bool same_bits(const std::vector<TraceColumn>& a, const std::vector<TraceColumn>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t c = 0; c < a.size(); ++c) {
    if (a[c].name != b[c].name || a[c].values.size() != b[c].values.size()) return false;
    for (std::size_t i = 0; i < a[c].values.size(); ++i)
      if (std::bit_cast<std::uint64_t>(a[c].values[i]) !=
          std::bit_cast<std::uint64_t>(b[c].values[i]))
        return false;
  }
  return true;
}

TEST(PackedTraceTest, TheSameBitsComeBack) {
  auto trace = half_sine(200);
  trace.push_back(
      {"odd", {0.0, -0.0, std::nan(""), std::numeric_limits<double>::infinity(), 5e-324}});
  trace.push_back({"empty", {}});
  EXPECT_TRUE(same_bits(unpacked(packed(trace)), trace));
  EXPECT_TRUE(unpacked(packed({})).empty());
}

TEST(PackedTraceTest, IsSmaller) {
  EXPECT_LT(packed(half_sine(200)).size(), std::size_t{2 * 200 * 8} * 9 / 10);
}

// Every byte of it counts: cut or changed bytes are an error or another trace, never a crash.
TEST(PackedTraceTest, DamageIsRefused) {
  const std::string bytes = packed(half_sine(30));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    try {
      unpacked(bytes.substr(0, length));
      FAIL() << "cut at " << length;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::corrupt_store);
    }
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x41);
    try {
      EXPECT_FALSE(same_bits(unpacked(changed), half_sine(30))) << i;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::corrupt_store);
    }
  }
}

}  // namespace
}  // namespace rebound
