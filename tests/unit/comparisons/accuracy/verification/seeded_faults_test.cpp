#include "comparisons/accuracy/verification/seeded_faults.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "comparisons/accuracy/verification/memory_growth.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/models/installation.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

const std::string caught_line = "sign lost | a.cpp | -x | +x | programs | Tests";
const std::string survived_line = "half lost | b.cpp | 0.5 | 1.0 | programs | Tests";

class SeededFaultsTest : public ::testing::Test {
 protected:
  void list(const std::string& more = "") const {
    std::ofstream(folder.path() / "faults.txt") << "# name | file | ...\n"
                                                << caught_line << "\n"
                                                << survived_line << "\n"
                                                << more;
  }
  std::filesystem::path mutated() const { return folder.path() / "a.cpp"; }
  std::string recorded(const std::string& line, const std::string& outcome) const {
    return "name\t" + sha256(line).substr(0, 16) + "\t" + outcome +
           "\tSign.Test\tabc123\t2026-01-02\ta.cpp:" + digest_of_source(mutated()) + "\n";
  }
  void results(const std::string& text) const {
    std::ofstream(folder.path() / "results.tsv") << text;
  }
  void SetUp() override { std::ofstream(mutated()) << "x = -x;  // sign\n"; }
  std::vector<SeededFault> faults() const {
    return read_seeded_faults(folder.path(), folder.path());
  }
  VerificationTable rows() const { return rows_of(faults()); }

  testing::TemporaryFolder folder;
};

TEST_F(SeededFaultsTest, NothingRecordedIsNoRow) {
  list();
  EXPECT_TRUE(rows().empty());
  EXPECT_NE(to_text(faults()).find("no run is recorded"), std::string::npos);
}

TEST_F(SeededFaultsTest, AllCaughtPasses) {
  list();
  results("# head\n" + recorded(caught_line, "caught") + recorded(survived_line, "caught"));
  EXPECT_TRUE(all_pass(rows()));
  const auto faults = this->faults();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].name, "sign lost");
  EXPECT_EQ(faults[0].file, "a.cpp");
  EXPECT_EQ(faults[0].caught_by, "Sign.Test");
  EXPECT_NE(to_text(faults).find("recorded on abc123 (2026-01-02); not run now"),
            std::string::npos);
}

TEST_F(SeededFaultsTest, ASurvivorFails) {
  list();
  results(recorded(caught_line, "caught") + recorded(survived_line, "survived"));
  EXPECT_FALSE(rows()[0].passes());
  EXPECT_TRUE(rows()[1].passes());
  EXPECT_TRUE(rows()[2].passes());
  EXPECT_FALSE(rows()[3].passes());  // half is less than 95 %
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

TEST_F(SeededFaultsTest, AnOutcomeOfOtherSourcesIsStaleAndFails) {
  list();
  results(recorded(caught_line, "caught") + recorded(survived_line, "caught"));
  EXPECT_TRUE(all_pass(rows()));
  std::ofstream(mutated()) << "x =\n -x;  // the sign of it\n";
  EXPECT_TRUE(all_pass(rows())) << "a comment and a line break make nothing stale";
  std::ofstream(mutated()) << "x = -x + 1;  // sign\n";
  EXPECT_EQ(rows()[2].result, 2.0);
  EXPECT_FALSE(rows()[2].passes());
  EXPECT_NE(to_text(faults()).find("stale"), std::string::npos);
  std::filesystem::remove(mutated());
  EXPECT_EQ(rows()[2].result, 2.0) << "the mutated file has gone";
}

// tests/mutations/run writes: printf 'x=-x;' | sha256sum | cut -c1-16
TEST_F(SeededFaultsTest, TheDigestIsThatOfTheScript) {
  EXPECT_EQ(digest_of_source(mutated()), "57a05eb7c45382cc");
  EXPECT_EQ(digest_of_source(folder.path() / "nothing.cpp"), "");
}

TEST_F(SeededFaultsTest, AnOutcomeWithoutItsSourcesIsStale) {
  list();
  const std::string line = recorded(caught_line, "caught");
  results(line.substr(0, line.rfind('\t')) + "\n" + recorded(survived_line, "caught"));
  EXPECT_EQ(rows()[2].result, 1.0);
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

// Fails where a fault, the file it is put into, or the test that catches it has changed since:
// bash tests/mutations/run --stale
TEST(SeededFaultsOfTheSources, EveryRecordedOutcomeIsOfTheseSources) {
  const auto faults = read_seeded_faults(seeded_faults_folder(), source_folder());
  ASSERT_FALSE(faults.empty());
  for (const SeededFault& fault : faults)
    EXPECT_EQ(fault.outcome, SeededFault::Outcome::caught) << fault.name << " in " << fault.file;
}

TEST(MemoryGrowthTest, AnArrayIsSeen) {
  const MemoryGrowth growth;
  ASSERT_TRUE(growth.known()) << "/proc/self/clear_refs cannot be written";
  {
    std::vector<char> array(50'000'000, 'x');
    EXPECT_EQ(array.back(), 'x');
  }
  EXPECT_GT(growth.bytes(), 49e6);
  EXPECT_LT(growth.bytes(), 60e6);
}

}  // namespace
}  // namespace rebound
