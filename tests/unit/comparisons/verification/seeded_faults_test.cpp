#include "comparisons/verification/seeded_faults.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "comparisons/results/digest.hpp"
#include "comparisons/verification/memory_growth.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

const std::string caught_line = "sign lost | a.cpp | -x | +x | programs | Tests";
const std::string survived_line = "half lost | b.cpp | 0.5 | 1.0 | programs | Tests";

class SeededFaultsTest : public ::testing::Test {
 protected:
  void list(const std::string& more = "") const {
    std::ofstream(folder.path() / "faults.txt")
        << "# name | file | ...\n" << caught_line << "\n" << survived_line << "\n" << more;
  }
  static std::string recorded(const std::string& line, const std::string& outcome) {
    return "name\t" + sha256(line).substr(0, 16) + "\t" + outcome + "\tSign.Test\tabc123\t2026-01-02\n";
  }
  void results(const std::string& text) const { std::ofstream(folder.path() / "results.tsv") << text; }
  VerificationTable rows() const { return rows_of(read_seeded_faults(folder.path())); }

  testing::TemporaryFolder folder;
};

TEST_F(SeededFaultsTest, NothingRecordedIsNoRow) {
  list();
  EXPECT_TRUE(rows().empty());
  EXPECT_NE(to_text(read_seeded_faults(folder.path())).find("no run is recorded"), std::string::npos);
}

TEST_F(SeededFaultsTest, AllCaughtPasses) {
  list();
  results("# head\n" + recorded(caught_line, "caught") + recorded(survived_line, "caught"));
  EXPECT_TRUE(all_pass(rows()));
  const auto faults = read_seeded_faults(folder.path());
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].name, "sign lost");
  EXPECT_EQ(faults[0].file, "a.cpp");
  EXPECT_EQ(faults[0].caught_by, "Sign.Test");
  EXPECT_NE(to_text(faults).find("recorded on abc123 (2026-01-02); not run now"), std::string::npos);
}

TEST_F(SeededFaultsTest, ASurvivorFails) {
  list();
  results(recorded(caught_line, "caught") + recorded(survived_line, "survived"));
  EXPECT_FALSE(rows()[0].passes());
  EXPECT_TRUE(rows()[1].passes());
  EXPECT_FALSE(rows()[2].passes());  // half is less than 95 %
}

TEST_F(SeededFaultsTest, AFaultThatIsNewOrChangedFails) {
  list("new one | c.cpp | y | z | programs | Tests\n");
  results(recorded(caught_line, "caught") + recorded(survived_line, "caught"));
  EXPECT_TRUE(rows()[0].passes());
  EXPECT_FALSE(rows()[1].passes());
  list();
  results(recorded(caught_line + " changed", "caught") + recorded(survived_line, "caught"));
  EXPECT_EQ(rows()[1].result, 1.0);
}

TEST_F(SeededFaultsTest, WhatTheScriptDidNotWriteIsCorrupt) {
  list();
  results("name,caught\n");
  EXPECT_EQ(testing::refusal_of([&] { rows(); }).code(), ExitCode::corrupt_store);
}

TEST(SeededFaultsOfTheSources, TheListIsRead) {
  std::ifstream list(seeded_faults_folder() / "faults.txt");
  EXPECT_TRUE(list.good());
}

TEST(MemoryGrowthTest, AnArrayIsSeen) {
  const MemoryGrowth growth;
  if (!growth.known()) GTEST_SKIP() << "the system does not tell";
  {
    std::vector<char> array(50'000'000, 'x');
    EXPECT_EQ(array.back(), 'x');
  }
  EXPECT_GT(growth.bytes(), 49e6);
  EXPECT_LT(growth.bytes(), 60e6);
}

}  // namespace
}  // namespace rebound
