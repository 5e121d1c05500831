#include "comparisons/io/results/key_words.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

TEST(KeyWordsTest, TheEndingIsTheUnit) {
  const auto expect = [](const char* key, const char* quantity, const char* unit) {
    const KeyWords words = words_of_key(key);
    EXPECT_EQ(words.quantity, quantity) << key;
    EXPECT_EQ(words.unit, unit) << key;
  };
  expect("peak_force_N", "peak force", "N");
  expect("contact_time_s", "contact time", "s");
  expect("rebound_speed_m_s", "rebound speed", "m/s");
  expect("impulse_N_s", "impulse", "N.s");
  expect("peak_deflection_m", "peak deflection", "m");
  expect("restitution_from_impulse", "restitution from impulse", "");
}

TEST(KeyWordsTest, APureNumberHasNothingBehindIt) {
  EXPECT_EQ(behind_number("1"), "");
  EXPECT_EQ(behind_number(""), "");
  EXPECT_EQ(behind_number("N/m"), " N/m");
}

}  // namespace
}  // namespace rebound
