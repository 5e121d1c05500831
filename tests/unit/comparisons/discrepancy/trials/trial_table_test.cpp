#include "comparisons/discrepancy/trials/trial_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "comparisons/discrepancy/trials/table_fields.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/discrepancy/trials/trial_examples.hpp"

namespace rebound {
namespace {

using testing::hidden;
using testing::nothing_hidden;
using testing::said;

/// A null, an effect with its size, and a pair, diagnosed with that seed.
TrialCollection examples(std::uint64_t seed = 3) {
  TrialTruth sized = hidden(2, "memory", "relaxation", 1234.5678901234567);
  sized.effects.front().in_registry = true;
  sized.effects.front().registry_size = 0.1 + 0.2;
  sized.nearest_family = 0.25;
  TrialTruth pair = hidden(3, "rate", "linear-dashpot");
  pair.effects.push_back(hidden(3, "out_of_family", "").effects.front());
  TrialOutcome named = said(2, "missing", "memory", "relaxation");
  named.size = 1.0 / 3.0;
  named.size_low = 0.2;
  named.size_high = 0.4;
  named.held_out_before = 7.1;
  named.seconds = 12.5;
  named.controls["random"] = answer_of_set({"hum"}, "measurement");
  TrialOutcome open = said(3, "one-of");
  open.said.candidates = {{"linear-dashpot", "adhesion"}, {"relaxation"}};
  open.said.candidate_families = {{"rate", "surface"}, {"rate"}};
  TrialCollection trials =
      testing::trials_of({said(1, "agrees"), named, open}, {nothing_hidden(1), sized, pair});
  const Json protocol = to_json(protocol_of_this_program(seed));
  const std::string digest = protocol_digest(protocol);
  for (TrialRecord& record : trials.records) record.outcome.protocol = digest;
  trials.protocols[digest] = protocol;
  return trials;
}

TEST(TrialTableTest, ScoresComeBackFromTheTable) {
  const testing::TemporaryFolder folder;
  const TrialCollection trials = examples();
  const TrialCollection again = read_trial_table(folder.write("t.csv", table_csv(trials)));
  EXPECT_EQ(table_csv(again), table_csv(trials));
  EXPECT_EQ(dump(to_json(score_trials(again))), dump(to_json(score_trials(trials))));
  ASSERT_EQ(again.records.size(), 3u);
  EXPECT_EQ(*again.records[1].truth.effects.front().registry_size, 0.1 + 0.2);
  EXPECT_EQ(again.records[2].outcome.said, trials.records[2].outcome.said);
  EXPECT_EQ(again.records[1].truth.nearest_family, 0.25);
  EXPECT_FALSE(again.records[1].truth.nearest_name.has_value());
  EXPECT_FALSE(again.records[1].outcome.held_out_after.has_value());
  EXPECT_EQ(again.records[1].outcome.controls.at("random").named, "hum");
}

/// As it was written before there were these columns.
std::string without_columns(const std::string& table, const std::set<std::string>& names) {
  std::string earlier;
  std::set<std::size_t> columns;
  for (const std::string& line : parts_of(table, '\n')) {
    if (line.empty()) continue;
    const Fields fields = parts_of(line, ',');
    Fields kept;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (names.contains(fields[i])) columns.insert(i);
      if (line.starts_with("#") || !columns.contains(i)) kept.push_back(fields[i]);
    }
    earlier += joined(kept, ',') + "\n";
  }
  return earlier;
}

TEST(TrialTableTest, ATableWithoutFamiliesOfCandidatesIsReadByTheirNames) {
  const testing::TemporaryFolder folder;
  const TrialCollection trials = examples();
  const TrialCollection read = read_trial_table(
      folder.write("e.csv", without_columns(table_csv(trials), {"candidate_families"})));
  const TrialAnswer& open = read.records[2].outcome.said;
  EXPECT_EQ(open.candidates, trials.records[2].outcome.said.candidates);
  EXPECT_TRUE(open.candidate_families.empty());
  EXPECT_TRUE(are_in_a_candidate(open, "rate", "surface"));
  EXPECT_FALSE(are_in_a_candidate(open, "memory", "surface")) << "each in another candidate";
}

TEST(TrialTableTest, ATableWithoutTheColumnOfBallsIsOfBallsThatObeyALaw) {
  const testing::TemporaryFolder folder;
  TrialCollection trials = examples();
  trials.records[0].truth.ball = "foam; nu 0.3";
  trials.records[0].truth.believed = "fem";
  const std::string text = table_csv(trials);
  const TrialTruth whole = read_trial_table(folder.write("t.csv", text)).records[0].truth;
  EXPECT_EQ(whole.ball, "foam; nu 0.3");
  EXPECT_EQ(whole.believed, "fem");
  const std::string earlier = without_columns(text, {"ball", "believed", "candidate_families"});
  const TrialCollection read = read_trial_table(folder.write("e.csv", earlier));
  ASSERT_EQ(read.records.size(), trials.records.size());
  EXPECT_EQ(read.records[0].truth.ball, "");
  EXPECT_EQ(read.records[0].truth.believed, "lumped");
  EXPECT_EQ(read.records[1].outcome.said, trials.records[1].outcome.said);
}

TEST(TrialTableTest, AChangedTableIsRefusedWithItsLine) {
  const testing::TemporaryFolder folder;
  const std::string text = table_csv(examples());
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const auto at = changed.find(from);
    if (at == std::string::npos) throw std::runtime_error("not in the table: " + from);
    changed.replace(at, from.size(), to);
    return testing::refusal_of([&] { read_trial_table(folder.write("t.csv", changed)); });
  };
  const Error number = refused("1234.5678901234567", "many");
  EXPECT_EQ(number.code(), ExitCode::corrupt_store);
  EXPECT_EQ(number.location().line, 4);
  EXPECT_EQ(number.location().key, "visible_chi_square");
  EXPECT_EQ(number.location().value, "many");
  EXPECT_EQ(refused("hidden_form", "form").location().line, 2);
  EXPECT_EQ(refused("\"close_criterion\":6", "\"close_criterion\":7").location().line, 1);
  EXPECT_EQ(refused("example,7,1,", "example,7,1").location().line, 3);
  EXPECT_EQ(testing::refusal_of([&] { read_trial_table(folder.path() / "none.csv"); }).code(),
            ExitCode::input_output_failed);
}

TEST(TrialTableTest, SeveralTablesAreScoredTogetherWhereThatIsSaid) {
  const testing::TemporaryFolder folder;
  TrialCollection others = examples(4);
  for (TrialRecord& record : others.records) record.truth.seed += 1;
  const std::vector<std::string> both = {folder.write("a.csv", table_csv(examples())).string(),
                                         folder.write("b.csv", table_csv(others)).string()};
  const TrialCollection together = read_trial_tables(both, true);
  EXPECT_EQ(together.records.size(), 6u);
  EXPECT_EQ(together.protocols.size(), 2u);
  const Error mixed = testing::refusal_of([&] { read_trial_tables(both, false); });
  EXPECT_EQ(mixed.location().key, "--mixed");
  const Error twice = testing::refusal_of([&] { read_trial_tables({both[1], both[1]}, true); });
  EXPECT_EQ(twice.code(), ExitCode::bad_input);
  EXPECT_NE(std::string(twice.what()).find("stands in"), std::string::npos) << twice.what();
}

// The table that the README quotes: of one protocol, every trial once, and as this version reads
// it.
TEST(StoredTrialsTest, CanBeScoredAgain) {
  const TrialCollection stored = read_trial_table(STORED_TRIALS);
  std::set<std::tuple<std::string, std::uint64_t, int>> known;
  for (const TrialRecord& record : stored.records)
    EXPECT_TRUE(known.emplace(record.truth.set, record.truth.seed, record.truth.trial).second)
        << "trial " << record.truth.trial;
  EXPECT_EQ(stored.protocols.size(), 1u);
  EXPECT_EQ(score_trials(stored).trials, static_cast<int>(stored.records.size()));
}

}  // namespace
}  // namespace rebound
