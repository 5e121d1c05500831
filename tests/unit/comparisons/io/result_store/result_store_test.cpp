#include "comparisons/io/result_store/result_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using Access = ResultStore::Access;

KeptMember member(int number) {
  KeptMember one{.key = "key" + std::to_string(number), .factors = "{}", .result = {}};
  for (std::size_t i = 0; i < one.result.scalars.size(); ++i)
    one.result.scalars[i] = std::sqrt(2.0 + number + static_cast<double>(i));
  one.result.scalars.back() = std::numeric_limits<double>::quiet_NaN();
  return one;
}

class ResultStoreTest : public ::testing::Test {
 protected:
  ExitCode refusal(const std::string& program = "one") const {
    try {
      ResultStore(file, Access::write, program);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::done;
  }

  testing::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "store.sqlite";
};

TEST_F(ResultStoreTest, WhatIsKeptComesBackToTheBit) {
  KeptMember failed = member(2);
  failed.result = {.failure = "the contact did not end"};
  {
    ResultStore store(file, Access::write, "one");
    store.keep({member(1), failed});
  }
  ResultStore store(file, Access::read, "one");
  const auto found = store.find("key1");
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i + 1 < found->scalars.size(); ++i)
    EXPECT_EQ(found->scalars[i], member(1).result.scalars[i]);
  EXPECT_TRUE(std::isnan(found->scalars.back()));
  EXPECT_EQ(store.find("key2")->failure, "the contact did not end");
  EXPECT_FALSE(store.find("key3"));
}

TEST_F(ResultStoreTest, NamedValuesComeBackInTheirOrder) {
  KeptMember one = member(1);
  one.result = {.values = {{.name = "size", .value = std::sqrt(0.1)},
                           {.name = "verdict", .value = "missing"},
                           {.name = "empty", .value = ""},
                           {.name = "absent", .value = std::nan("")}}};
  ResultStore(file, Access::write, "one").keep({one, member(2)});
  ResultStore store(file, Access::read, "one");
  const auto found = store.find("key1");
  ASSERT_EQ(found->values.size(), 4u);
  EXPECT_EQ(found->values[0].name, "size");
  EXPECT_EQ(std::get<double>(found->values[0].value), std::sqrt(0.1));
  EXPECT_EQ(std::get<std::string>(found->values[1].value), "missing");
  EXPECT_EQ(std::get<std::string>(found->values[2].value), "");
  EXPECT_TRUE(std::isnan(std::get<double>(found->values[3].value)));
  EXPECT_TRUE(store.find("key2")->values.empty());
}

TEST_F(ResultStoreTest, AChangedTextOfAValueIsSeen) {
  KeptMember one = member(1);
  one.result = {.values = {{.name = "verdict", .value = "unexplained"}}};
  ResultStore(file, Access::write, "one").keep({one});
  std::string text = testing::read_whole(file);
  text.replace(text.find("unexplained"), 1, "U");
  folder.write("store.sqlite", text);
  ResultStore store(file, Access::read, "one");
  EXPECT_THROW(store.find("key1"), Error);
}

TEST_F(ResultStoreTest, TwoWritersOfOneFileDoNoHarm) {
  const auto write = [&] {
    ResultStore store(file, Access::write, "one");
    for (int i = 0; i < 200; ++i) store.keep({member(i), member(i + 1)});
  };
  std::thread first(write), second(write);
  first.join();
  second.join();
  ResultStore store(file, Access::read, "one");
  for (int i = 0; i <= 200; ++i) {
    const auto found = store.find("key" + std::to_string(i));
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->scalars[0], member(i).result.scalars[0]);
  }
}

TEST_F(ResultStoreTest, ManyAreFoundTogetherAndTheStoreIsWrittenToAfter) {
  ResultStore store(file, Access::write, "one");
  store.keep({member(1), member(3)});
  std::vector<std::size_t> places;
  const std::vector<std::string> keys{"key3", "key2", "key1"};
  const auto look = [&](std::size_t i, const MemberResult& result) {
    places.push_back(i);
    EXPECT_EQ(result.scalars[0], member(i == 0 ? 3 : 1).result.scalars[0]);
  };
  store.find_each(keys, look);
  EXPECT_EQ(places, (std::vector<std::size_t>{0, 2}));
  EXPECT_THROW(store.find_each(keys,
                               [](std::size_t, const MemberResult&) -> void {
                                 throw std::runtime_error("no more");
                               }),
               std::runtime_error);
  store.keep({member(2)});
  EXPECT_TRUE(ResultStore(file, Access::read, "one").find("key2")) << "no transaction is left open";
}

TEST_F(ResultStoreTest, AStoreOfAnyProgramIsReadAndNamed) {
  { ResultStore(file, Access::write, "one").keep({member(1)}); }
  ResultStore store(file);
  EXPECT_EQ(store.program(), "one");
  EXPECT_TRUE(store.find("key1"));
  EXPECT_THROW(store.keep({member(2)}), Error);
}

TEST_F(ResultStoreTest, AnotherProgramsStoreIsRefusedAndLeftAsItIs) {
  ResultStore(file, Access::write, "one").keep({member(1)});
  const std::string before = testing::read_whole(file);
  EXPECT_EQ(refusal("another"), ExitCode::corrupt_store);
  EXPECT_EQ(testing::read_whole(file), before);
  EXPECT_EQ(refusal("one"), ExitCode::done);
}

TEST_F(ResultStoreTest, ADamagedStoreIsRefusedAndLeftAsItIs) {
  {
    ResultStore store(file, Access::write, "one");
    for (int i = 0; i < 500; ++i) store.keep({member(i)});
  }
  const std::string whole = testing::read_whole(file);
  const auto version = [&] {
    std::string text = whole;
    text[63] = 9;  // user_version, big-endian at byte 60
    return text;
  };
  const auto overwritten = [&](std::size_t at, std::size_t length) {
    return whole.substr(0, at) + std::string(length, '\x5a') + whole.substr(at + length);
  };
  for (const std::string& text :
       {std::string(), std::string("not a store"), whole.substr(0, 50),
        whole.substr(0, whole.size() / 2), version(), overwritten(0, 16), overwritten(68, 4),
        overwritten(100, 300), overwritten(whole.size() / 2, 4096)}) {
    folder.write("store.sqlite", text);
    EXPECT_EQ(refusal(), ExitCode::corrupt_store) << text.size();
    EXPECT_EQ(testing::read_whole(file), text) << text.size();
  }
}

TEST_F(ResultStoreTest, AChangedBitOfAValueIsSeen) {
  ResultStore(file, Access::write, "one").keep({member(1)});
  std::string text = testing::read_whole(file);
  const double value = member(1).result.scalars[2];
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  std::reverse(bytes.begin(), bytes.end());  // stored big-endian
  const auto at = text.find(bytes);
  ASSERT_NE(at, std::string::npos);
  text[at + 6] ^= 1;
  folder.write("store.sqlite", text);
  ResultStore store(file, Access::read, "one");
  try {
    store.find("key1");
    FAIL() << "the damaged value was given out";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::corrupt_store);
  }
}

TEST_F(ResultStoreTest, ATraceComesBackToTheBit) {
  KeptMember one = member(1);
  one.result.trace = {{"time_s", {0.0, 1e-3, std::sqrt(1e-5)}}, {"force_N", {-0.0, 12.5, 1e-300}}};
  ResultStore(file, Access::write, "one").keep({one, member(2)});
  ResultStore store(file, Access::read, "one");
  const auto found = store.find("key1");
  ASSERT_EQ(found->trace.size(), 2u);
  EXPECT_EQ(found->trace[1].name, "force_N");
  EXPECT_EQ(found->trace[0].values, one.result.trace[0].values);
  EXPECT_TRUE(std::signbit(found->trace[1].values[0]));
  EXPECT_TRUE(store.find("key2")->trace.empty());
}

}  // namespace
}  // namespace rebound
