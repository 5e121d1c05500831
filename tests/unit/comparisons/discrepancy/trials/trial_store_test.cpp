// Outcomes of trials in a store of results: all of them comes back, and nothing damaged is taken.
#include "comparisons/discrepancy/trials/trial_store.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "comparisons/discrepancy/trials/table_fields.hpp"
#include "comparisons/io/results/digest.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

class TrialStoreTest : public ::testing::Test {
 protected:
  TrialStoreTest() : protocol(to_json(protocol_of_this_program(1))) {}

  TrialOutcome outcome_with_everything() const {
    TrialOutcome outcome = testing::said(7, "missing", "rate", "linear-dashpot");
    outcome.said.candidates = {{"linear-dashpot"}, {"relaxation", "gain"}};
    outcome.said.nearest = {"linear-dashpot", "tsuji"};
    outcome.failure = "why, in words; \"quoted\"";
    outcome.size = 1.0 / 3.0;
    outcome.size_low = std::numeric_limits<double>::denorm_min();
    outcome.size_high = std::numeric_limits<double>::infinity();
    outcome.held_out_before = 3.25;
    outcome.warnings = {"one", "another, longer"};
    outcome.controls["random"] = answer_of_set({"relaxation"}, "memory");
    outcome.protocol = protocol_digest(protocol);
    return outcome;
  }

  std::filesystem::path file() const {
    return folder.path() / ("trials-" + protocol_digest(protocol) + ".sqlite");
  }

  testing::TemporaryFolder folder;
  Json protocol;
};

TEST_F(TrialStoreTest, AllOfAnOutcomeComesBack) {
  const TrialOutcome outcome = outcome_with_everything();
  {
    TrialStore store(folder.path());
    store.write(protocol);
    store.keep("data", outcome);
  }
  TrialStore store(folder.path());
  EXPECT_FALSE(store.find("other data"));
  const auto again = store.find("data");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->failure, outcome.failure);
  EXPECT_EQ(again->warnings, outcome.warnings);
  const TrialRecord kept{.truth = {}, .outcome = *again}, given{.truth = {}, .outcome = outcome};
  for (const TableField& field : outcome_fields())
    EXPECT_EQ(field.write(kept), field.write(given)) << field.name;
  EXPECT_EQ(store.protocols().at(outcome.protocol), protocol);
}

TEST_F(TrialStoreTest, AStoreUnderTheNameOfAnotherProtocolIsRefused) {
  TrialStore(folder.path()).write(protocol);
  std::filesystem::rename(file(), folder.path() / "trials-0123456789ab.sqlite");
  EXPECT_EQ(testing::refusal_of([&] { TrialStore store(folder.path()); }).code(),
            ExitCode::corrupt_store);
}

TEST_F(TrialStoreTest, AChangedByteOfAnOutcomeIsRefusedAndTheFileStays) {
  {
    TrialStore store(folder.path());
    store.write(protocol);
    store.keep("data", outcome_with_everything());
  }
  std::string bytes = testing::read_whole(file());
  const auto at = bytes.find("another, longer");
  ASSERT_NE(at, std::string::npos) << "of the last connection the log is part of the file";
  bytes[at] = 'o';
  folder.write(file().filename().string(), bytes);
  EXPECT_EQ(testing::refusal_of([&] { TrialStore(folder.path()).find("data"); }).code(),
            ExitCode::corrupt_store);
  EXPECT_EQ(testing::read_whole(file()), bytes);
}

TEST_F(TrialStoreTest, ATrialIsKnownByItsFiles) {
  std::filesystem::create_directories(folder.path() / "trial");
  folder.write("trial/data.csv", "1");
  const std::string digest = digest_of_folder(folder.path() / "trial");
  EXPECT_EQ(digest, digest_of_folder(folder.path() / "trial"));
  folder.write("trial/data.csv", "2");
  EXPECT_NE(digest, digest_of_folder(folder.path() / "trial"));
  folder.write("trial/data.csv", "1");
  std::filesystem::rename(folder.path() / "trial/data.csv", folder.path() / "trial/other.csv");
  EXPECT_NE(digest, digest_of_folder(folder.path() / "trial"));
}

}  // namespace
}  // namespace rebound
