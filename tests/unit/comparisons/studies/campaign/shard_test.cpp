#include "comparisons/studies/campaign/shard.hpp"

#include <gtest/gtest.h>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

TEST(ShardTest, PartsAreReadAndTheirLimitsHeld) {
  const Shard shard = parse_shard("3/10");
  EXPECT_EQ(shard.number, 3u);
  EXPECT_EQ(shard.of, 10u);
  for (const char* text :
       {"", "3", "0/10", "11/10", "3/", "/3", "a/b", "1/2/3", "-1/2", "1/200000"})
    EXPECT_THROW(parse_shard(text), Error) << text;
}

}  // namespace
}  // namespace rebound
