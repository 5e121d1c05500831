// Outcomes say what they were made with, and those of two protocols are not taken for one set.
#include "comparisons/discrepancy/trials/trial_protocol.hpp"

#include <gtest/gtest.h>

#include "comparisons/discrepancy/trials/trial_store.hpp"
#include "comparisons/io/results/digest.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

Json protocol_with(const SelectionRules& rules, std::uint64_t seed = 1) {
  TrialProtocol protocol = protocol_of_this_program(seed);
  protocol.rules = rules;
  return to_json(protocol);
}

TEST(TrialProtocolTest, EveryThresholdIsAnotherProtocol) {
  const std::string frozen = protocol_digest(protocol_with({}));
  EXPECT_EQ(frozen, protocol_digest(protocol_with({})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.false_gap_level = 0.03})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.candidate_level = 0.003})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.close_criterion = 7.0})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.smallest_adequate_p = 2e-3})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.fitted_singles = 11})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.fitted_faults = 7})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.fitted_pairs = 9})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.most_effects = 2})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.bootstrap_draws = 99})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({.least_inclusion = 0.7})));
  EXPECT_NE(frozen, protocol_digest(protocol_with({}, 2)));
  EXPECT_NE(frozen, protocol_digest(to_json(protocol_of_this_program(1, true)))) << "FE asked";
}

/// A trial without an outcome.
std::filesystem::path add_trial(const testing::TemporaryFolder& folder, int number) {
  const std::string name = "trials/000" + std::to_string(number);
  std::filesystem::create_directories(folder.path() / name);
  folder.write(name + "/data.csv", name);
  return folder.path() / name;
}

/// A folder in which trials have their outcomes, each with a protocol of its own.
TrialRun trials_with(const testing::TemporaryFolder& folder, const std::vector<Json>& protocols) {
  const auto outcomes = folder.path() / "outcomes";
  std::filesystem::create_directories(outcomes);
  int number = 0;
  for (const Json& protocol : protocols) {
    const auto trial = add_trial(folder, ++number);
    TrialOutcome outcome = testing::said(number, "agrees");
    outcome.protocol = protocol_digest(protocol);
    TrialStore store(outcomes);
    store.write(protocol);
    store.keep(digest_of_folder(trial), outcome);
  }
  return {.folders = {{.data = folder.path(), .outcomes = outcomes}}};
}

TEST(TrialProtocolTest, OutcomesOfTwoProtocolsAreRefusedUnlessItIsSaid) {
  const testing::TemporaryFolder folder;
  TrialRun run = trials_with(folder, {protocol_with({}), protocol_with({.close_criterion = 7.0})});
  const Error refusal = testing::refusal_of([&] { run_trials(run); });
  EXPECT_EQ(refusal.code(), ExitCode::bad_input);
  EXPECT_EQ(refusal.location().key, "--mixed");
  run.mixed = true;
  EXPECT_TRUE(run_trials(run).complete());
}

TEST(TrialProtocolTest, OutcomesOfAnotherProgramAreScoredButNotAddedTo) {
  const testing::TemporaryFolder folder;
  const TrialRun run = trials_with(folder, {protocol_with({.close_criterion = 7.0})});
  EXPECT_TRUE(run_trials(run).complete()) << "nothing is left to be diagnosed";
  add_trial(folder, 2);
  EXPECT_EQ(testing::refusal_of([&] { run_trials(run); }).code(), ExitCode::bad_input);
  EXPECT_EQ(TrialStore(folder.path() / "outcomes").protocols().size(), 1u)
      << "refused before the first diagnosis";
}

TEST(TrialRunTest, NoTruthIsOpenedBeforeTheLastOutcome) {
  const testing::TemporaryFolder folder;
  TrialRun run = trials_with(folder, {protocol_with({})});
  add_trial(folder, 2);
  run.most = 0;
  const TrialProgress progress = run_trials(run);
  EXPECT_EQ(progress.with_outcome, 1u);
  EXPECT_EQ(progress.trials, 2u);
  EXPECT_EQ(testing::refusal_of([&] { open_trials(run); }).code(), ExitCode::bad_input);
}

}  // namespace
}  // namespace rebound
