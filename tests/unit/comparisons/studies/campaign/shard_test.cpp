#include "comparisons/studies/campaign/shard.hpp"

#include <gtest/gtest.h>

#include <vector>

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

TEST(ShardTest, EveryMemberIsDealtOnce) {
  for (const std::size_t of : {1u, 3u, 4u, 7u})
    for (const std::size_t all : {0u, 1u, 6u, 28u, 29u, 400u}) {
      std::vector<int> dealt(all, 0);
      for (std::size_t number = 1; number <= of; ++number) {
        const Shard shard{.number = number, .of = of};
        std::size_t count = 0;
        for (std::size_t round = 0; round * of < all; ++round)
          if (const auto member = member_in_round(shard, round); member < all) {
            ++dealt[member];
            ++count;
          }
        EXPECT_EQ(count, members_of(shard, all));
        EXPECT_LE(count, all / of + 1);
      }
      for (const int times : dealt) EXPECT_EQ(times, 1);
    }
}

// The last factor of a grid of four values changes fastest: dealt in turn, each of four shards
// would get one value only.
TEST(ShardTest, NoShardGetsOneValueOfAGridOnly) {
  for (std::size_t number = 1; number <= 4; ++number) {
    std::vector<int> values(4, 0);
    for (std::size_t round = 0; round < 400; ++round)
      ++values[member_in_round({.number = number, .of = 4}, round) % 4];
    for (const int count : values) EXPECT_NEAR(count, 100, 40);
  }
}

}  // namespace
}  // namespace rebound
