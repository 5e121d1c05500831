#include "comparisons/io/toml/nearest_key.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

TEST(NearestKeyTest, FindsOneTypingError) {
  const std::vector<std::string> keys{"mass", "diameter", "relaxation_time"};
  EXPECT_EQ(nearest_key("mas", keys), "mass");
  EXPECT_EQ(nearest_key("masss", keys), "mass");
  EXPECT_EQ(nearest_key("amss", keys), "mass");
  EXPECT_EQ(nearest_key("diametre", keys), "diameter");
  EXPECT_EQ(nearest_key("relaxation-time", keys), "relaxation_time");
}

TEST(NearestKeyTest, FindsANameThatWasCutShort) {
  EXPECT_EQ(nearest_key("poisson", {"mass", "poisson_ratio"}), "poisson_ratio");
  EXPECT_EQ(nearest_key("relaxation", {"relaxation_time", "relaxation_ratio"}), "");
  EXPECT_EQ(nearest_key("po", {"mass", "poisson_ratio"}), "");
}

TEST(NearestKeyTest, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest_key("colour", {"mass", "diameter"}), "");
  EXPECT_EQ(nearest_key(std::string(100000, 'm'), {"mass"}), "");
}

}  // namespace
}  // namespace rebound
