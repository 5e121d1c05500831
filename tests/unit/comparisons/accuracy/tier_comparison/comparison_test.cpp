#include "comparisons/accuracy/tier_comparison/comparison.hpp"

#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "comparisons/accuracy/tier_comparison/comparison_output.hpp"
#include "comparisons/io/report/check.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;
using testing::TemporaryFolder;

TierRecord record_of(const std::string& tier, double speed) {
  TierRecord record{.tier = tier,
                    .speed = speed,
                    .separation = "zero-force",
                    .input_sha256 = "abc",
                    .discretisation = {tier == "fem" ? "explicit" : "lumped", 100, 120, 1e-6},
                    .scalars = {}};
  for (const std::string& key : compared_keys())
    record.scalars[key] = {.value = 1.0, .rounding = 1e-9, .step = 1e-4, .numerical = 5e-3};
  return record;
}

const CompareCase both{.name = "a", .lumped = "l", .fem = "f", .speeds = {}, .agreement = {}};

TEST(TierComparisonTest, WhatIsTheSameHasNotMoved) {
  const std::vector<TierRecord> records{record_of("lumped", 5), record_of("fem", 5)};
  const CaseComparison same = compare_case(both, records, records);
  EXPECT_TRUE(same.passes());
  EXPECT_EQ(same.movements.size(), 2 * compared_keys().size());
  EXPECT_EQ(same.gaps.size(), compared_keys().size());
}

struct Shift {
  const char* name;
  double change;
  bool other_step, other_mesh, moves;
};

/// The tolerance is of the error that the runs do not share.
class Shifted : public ::testing::TestWithParam<Shift> {};

TEST_P(Shifted, CountsWhereNumericalErrorDoesNotExplainIt) {
  const Shift& c = GetParam();
  const std::vector<TierRecord> before{record_of("lumped", 5), record_of("fem", 5),
                                       record_of("fem", 15)};
  std::vector<TierRecord> now = before;
  now[2].scalars["peak_force_N"].value += c.change;
  if (c.other_step) now[2].discretisation.smallest_step *= 1.01;
  if (c.other_mesh) now[2].discretisation.cells = 144;
  const CaseComparison comparison = compare_case(both, now, before);
  EXPECT_EQ(comparison.passes(), !c.moves);
  if (!c.moves) return;
  EXPECT_EQ(comparison.moved_tiers(), std::vector<std::string>{"fem"});
  for (const Movement& one : comparison.movements) {
    const bool meant = one.tier == "fem" && one.speed == 15.0 && one.key == "peak_force_N";
    EXPECT_EQ(one.has_moved(), meant);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Shifted,
                         ::testing::Values(Shift{"Rounding", 1e-9, false, false, false},
                                           Shift{"BeyondRounding", 1e-8, false, false, true},
                                           Shift{"StepsShare", 1.5e-4, true, false, false},
                                           Shift{"BeyondTheStep", 4e-4, true, false, true},
                                           Shift{"AnotherMesh", 8e-3, false, true, false},
                                           Shift{"BeyondTheMesh", 2e-2, false, true, true}),
                         [](const auto& c) { return std::string(c.param.name); });

TEST(TierComparisonTest, ARunThatHasLostItsAccuracyDoesNotWidenItsOwnTolerance) {
  const std::vector<TierRecord> before{record_of("lumped", 5)};
  std::vector<TierRecord> now = before;
  now[0].scalars["restitution"] = {.value = 1.3, .rounding = 0.6, .step = 0.6, .numerical = 0.6};
  EXPECT_FALSE(compare_case(both, now, before).passes());
}

TEST(TierComparisonTest, AnotherRuleOrInputIsSaid) {
  const std::vector<TierRecord> before{record_of("lumped", 5)};
  std::vector<TierRecord> now = before;
  now[0].separation = "zero-deflection";
  now[0].input_sha256 = "def";
  const auto remarks = compare_case(both, now, before).remarks;
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_NE(remarks[0].find("zero-deflection"), std::string::npos);
}

TEST(TierComparisonTest, AGapIsJudgedAgainstAStatedShareOnly) {
  std::vector<TierRecord> records{record_of("lumped", 5), record_of("fem", 5)};
  records[0].scalars["restitution"].value = 1.05;
  EXPECT_TRUE(compare_case(both, records, {}).passes());
  CompareCase strict = both;
  strict.agreement = {{"restitution", 0.03}};
  EXPECT_FALSE(compare_case(strict, records, {}).passes());
  strict.agreement = {{"restitution", 0.045}};  // and both numerical errors, 0.01
  EXPECT_TRUE(compare_case(strict, records, {}).passes());
}

TEST(TierComparisonTest, BaselinesComeBackAndCorruptOnesAreRefused) {
  const TemporaryFolder folder;
  const std::vector<TierRecord> records{record_of("lumped", 5), record_of("fem", 5)};
  write_baseline(folder.path(), "a", records);
  const auto again = read_baseline(folder.path(), "a");
  EXPECT_TRUE(compare_case(both, records, again).remarks.empty());
  EXPECT_EQ(again[1].scalars.at("restitution").numerical, 5e-3);
  EXPECT_EQ(refusal_of([&] { read_baseline(folder.path(), "b"); }).code(), ExitCode::bad_input);
  const std::string whole = testing::read_whole(folder.path() / "a.json");
  for (const std::string& broken :
       {whole.substr(0, whole.size() / 2), std::string("{}"), std::string(),
        std::string("{\"schema\": 1, \"case\": \"b\", \"records\": []}")}) {
    folder.write("a.json", broken);
    EXPECT_EQ(refusal_of([&] { read_baseline(folder.path(), "a"); }).code(),
              ExitCode::corrupt_store);
  }
  EXPECT_EQ(refusal_of([&] { compare_case(both, records, {record_of("fem", 7)}); }).code(),
            ExitCode::bad_input);
}

TEST(TierComparisonTest, ThePageIsDrawn) {
  const std::vector<TierRecord> before{record_of("lumped", 5), record_of("fem", 5)};
  std::vector<TierRecord> now = before;
  now[0].scalars["restitution"].value = 1.05;
  const std::vector<CaseComparison> cases{compare_case(both, now, before)};
  const report::Report page = comparison_report(cases);
  report::check_report(page);
  EXPECT_NE(page.headline.find("1 of 1 cases"), std::string::npos);
  EXPECT_FALSE(to_json(cases)["passes"].get<bool>());
}

/// The lumped half of the baselines that ship with the program: a changed law shows here, pinned
/// to its tier, in a second.
TEST(StoredBaselines, OfTheLumpedTierHold) {
  const std::filesystem::path folder = REBOUND_TIERS_FOLDER;
  const CompareFile file = read_compare_file(Document::load(folder / "compare.toml"));
  ASSERT_EQ(file.cases.size(), 5u);
  for (CompareCase one : file.cases) {
    one.fem.clear();
    std::vector<TierRecord> before = read_baseline(folder / "baselines", one.name);
    std::erase_if(before, [](const TierRecord& record) { return record.tier != "lumped"; });
    ASSERT_FALSE(before.empty());
    const CaseComparison found = compare_case(one, run_case(one, folder, {}), before);
    EXPECT_TRUE(found.passes()) << to_text({found});
    EXPECT_TRUE(found.remarks.empty());
  }
}

struct BadFile {
  const char* name;
  const char* text;
  const char* key;
};

class CompareFileRefuses : public ::testing::TestWithParam<BadFile> {};

TEST_P(CompareFileRefuses, WithTheKey) {
  const Document document =
      Document::parse(std::string("schema = 1\n") + GetParam().text, "compare.toml");
  const Error error = refusal_of([&] { read_compare_file(document); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().key, GetParam().key);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, CompareFileRefuses,
    ::testing::Values(
        BadFile{"NoTier", "[[case]]\nname = \"a\"\n", "case[0]"},
        BadFile{"NoFileName", "[[case]]\nname = \"../a\"\nfem = \"f\"\n", "case[0].name"},
        BadFile{"SameName",
                "[[case]]\nname = \"a\"\nfem = \"f\"\n[[case]]\nname = \"a\"\nfem = \"f\"\n",
                "case[1].name"},
        BadFile{"NoSpeed", "[[case]]\nname = \"a\"\nfem = \"f\"\nspeeds = [\"5\"]\n",
                "case[0].speeds"},
        BadFile{"NegativeSpeed", "[[case]]\nname = \"a\"\nfem = \"f\"\nspeeds = [\"-5 m/s\"]\n",
                "case[0].speeds"},
        BadFile{"OneTierAgrees",
                "[[case]]\nname = \"a\"\nfem = \"f\"\n[case.agreement]\nrestitution = 0.1\n",
                "case[0].agreement"},
        BadFile{"UnknownScalar",
                "[[case]]\nname = \"a\"\nfem = \"f\"\nlumped = \"l\"\n[case.agreement]\nx = 0.1\n",
                "case[0].agreement.x"}),
    [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace rebound
