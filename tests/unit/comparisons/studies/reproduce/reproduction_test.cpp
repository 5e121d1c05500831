#include "comparisons/studies/reproduce/reproduction.hpp"
#include "comparisons/models/installation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/comparisons/studies/reproduce/whole_reproduction.hpp"

namespace rebound {
namespace {

using testing::whole_reproduction;

std::size_t differing(const Reproduction& reproduction, const std::string& table) {
  return static_cast<std::size_t>(std::count_if(
      reproduction.rows.begin(), reproduction.rows.end(),
      [&](const Row& row) { return row.key.table == table && row.verdict == Verdict::differs; }));
}

const Row& row_of(const std::string& table, const std::string& quantity,
                  const std::string& core = "", double speed = -1.0) {
  for (const Row& row : whole_reproduction().rows)
    if (row.key.table == table && row.key.quantity == quantity && row.key.core == core &&
        (speed < 0.0 || row.key.speed == speed))
      return row;
  throw std::logic_error("no row " + table + ", " + quantity);
}

TEST(ReproductionTest, EveryComputedNumberOfTheTablesHasARow) {
  const auto rows_in = [](const std::string& table) {
    return std::count_if(whole_reproduction().rows.begin(), whole_reproduction().rows.end(),
                         [&](const Row& row) { return row.key.table == table; });
  };
  EXPECT_EQ(rows_in("Table 2"), 4);
  EXPECT_EQ(rows_in("Table 3"), 12);
  EXPECT_EQ(rows_in("Table 4"), 36);
  EXPECT_EQ(rows_in("Table 5"), 24);
}

TEST(ReproductionTest, TableFourReproducesWhole) {
  EXPECT_EQ(differing(whole_reproduction(), "Table 4"), 0u);
}

TEST(ReproductionTest, TablesTwoAndFiveDoNot) {
  EXPECT_EQ(differing(whole_reproduction(), "Table 2"), 2u);
  EXPECT_EQ(differing(whole_reproduction(), "Table 5"), 18u);
}

TEST(ReproductionTest, TableFiveDiffersFromTheRoundedTableFourToo) {
  const auto impact = [](const std::vector<double>& in) {
    return KelvinVoigtImpact({.stiffness = in[0], .damping = in[1]}, {.mass = in[2], .speed = 1.0});
  };
  constexpr SeparationRule rule = SeparationRule::zero_deflection;
  for (const PaperCore& core : whole_reproduction().paper.cores) {
    if (core.name == "A") continue;
    for (const PaperShot& shot : core.shots) {
      const std::vector<PrintedNumber> inputs{shot.published.linear_stiffness,
                                              shot.published.linear_damping, core.mass};
      const Interval time = corner_range(
          [&](const std::vector<double>& in) { return impact(in).contact_time(rule); }, inputs);
      const Interval restitution = corner_range(
          [&](const std::vector<double>& in) { return impact(in).restitution(rule); }, inputs);
      EXPECT_FALSE(overlap(time, rounding_interval(shot.published.linear_contact_time)));
      EXPECT_FALSE(overlap(restitution, rounding_interval(shot.published.linear_restitution)));
    }
  }
}

TEST(ReproductionTest, TwoPercentagesOfSectionFourFourDoNot) {
  EXPECT_EQ(differing(whole_reproduction(), "Section 4.4"), 2u);
  const Row& time = row_of("Section 4.4", "mean difference of contact time, linear model");
  const Row& restitution = row_of("Section 4.4", "mean difference of restitution, linear model");
  EXPECT_EQ(time.verdict, Verdict::differs);
  EXPECT_EQ(restitution.verdict, Verdict::differs);
  EXPECT_NEAR(time.computed, 6.304, 5e-4);  // sums of the printed columns by hand
  EXPECT_NEAR(restitution.computed, 12.555, 5e-4);
}

TEST(ReproductionTest, NumbersThatFollowAreSaidToFollow) {
  EXPECT_EQ(row_of("Section 4.4", "restitutions over-predicted, of 12").verdict,
            Verdict::reproduces);
  EXPECT_EQ(row_of("Section 4.3", "contact times under-predicted, of 12").verdict,
            Verdict::reproduces);
  EXPECT_EQ(row_of("Section 4.5", "mean measured restitution at 15 m/s").verdict,
            Verdict::within_rounding);
  EXPECT_EQ(row_of("Table 5", "linear contact time", "A", 5.0).verdict, Verdict::reproduces);
}

TEST(ReproductionTest, CornersEncloseTheComputedNumber) {
  for (const Row& row : whole_reproduction().rows) {
    EXPECT_LE(row.range.low, row.computed) << row.key.quantity;
    EXPECT_GE(row.range.high, row.computed) << row.key.quantity;
  }
}

TEST(ReproductionTest, JsonHasTheContractsKeys) {
  const Json json = to_json(whole_reproduction());
  EXPECT_EQ(json["schema"], 1);
  ASSERT_EQ(json["rows"].size(), whole_reproduction().rows.size());
  for (const Json& row : json["rows"])
    for (const char* key : {"table", "core", "speed_m_s", "quantity", "published", "computed",
                            "low", "high", "verdict"})
      EXPECT_TRUE(row.contains(key)) << key;
  for (const Json& finding : json["findings"])
    for (const char* key : {"id", "statement", "evidence"})
      EXPECT_FALSE(finding.at(key).get<std::string>().empty());
  EXPECT_EQ(json["rows"][0]["published"], 2.81e5);
}

TEST(ReproductionTest, TextNamesDifferencesFirst) {
  const std::string text = to_text(whole_reproduction());
  const auto first_differing = text.find("\ndiffers");
  const auto first_following = text.find("\nreproduces");
  ASSERT_NE(first_differing, std::string::npos);
  ASSERT_NE(first_following, std::string::npos);
  EXPECT_LT(first_differing, first_following);
}

/// The paper's data in a folder of the test's own, with one text replaced.
void copy_with(const testing::TemporaryFolder& folder, const std::string& file,
               const std::string& from, const std::string& to) {
  std::filesystem::copy(data_folder(), folder.path(), std::filesystem::copy_options::recursive);
  std::string text = testing::read_whole(folder.path() / file);
  const auto place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
  folder.write(file, text);
}

TEST(ReproductionTest, TheMassItNamesDoesRepairCoreB) {
  const testing::TemporaryFolder folder;
  copy_with(folder, "sliotar-core-b/dataset.toml", "mass = \"89.9 g\"", "mass = \"84.4 g\"");
  const Reproduction changed = reproduce(folder.path());
  EXPECT_EQ(differing(whole_reproduction(), "Table 5") - differing(changed, "Table 5"), 6u);
  EXPECT_GT(differing(changed, "Table 4"), 0u);  // which was made with the other mass
}

TEST(ReproductionTest, AnUnknownClaimIsRefused) {
  const testing::TemporaryFolder folder;
  copy_with(folder, "sliotar-paper/claims.toml", "id = \"lowest-speed\"", "id = \"no-such\"");
  EXPECT_THROW(reproduce(folder.path()), Error);
}

TEST(ReproductionTest, AMissingFolderIsAReadingError) {
  try {
    reproduce("no-such-folder");
    FAIL() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  }
}

}  // namespace
}  // namespace rebound
