// Published constants give what their sources state, and a wrong constant does not.
#include "comparisons/accuracy/foams/published_foam.hpp"

#include <gtest/gtest.h>

#include "comparisons/accuracy/foams/foam_rows.hpp"
#include "comparisons/models/fem_access/material_laws.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

TEST(PublishedFoamsTest, GiveWhatTheirSourcesState) {
  const auto foams = published_foams();
  ASSERT_EQ(foams.size(), 3u);
  const VerificationTable table = verify_foams(material_laws(), foams);
  EXPECT_EQ(table.size(), 9u);
  for (const VerificationRow& row : table)
    EXPECT_TRUE(row.passes()) << row.quantity << ": " << row.result << " for " << row.target;
}

TEST(PublishedFoamsTest, AWrongConstantFails) {
  auto foams = published_foams();
  for (PublishedFoam& foam : foams) {
    foam.material.youngs_modulus *= 1.2;
    if (!foam.material.terms.empty()) foam.material.terms[0].exponent *= 1.2;
  }
  std::size_t failures = 0;
  for (const VerificationRow& row : verify_foams(material_laws(), foams)) failures += !row.passes();
  // Poisson ratios stay, and cork's plateau, which goes as modulus over exponent.
  EXPECT_EQ(failures, 6u);
}

TEST(PublishedFoamsTest, CurvesAreWritten) {
  const testing::TemporaryFolder folder;
  write_foam_curves(material_laws(), published_foams(), folder.path());
  EXPECT_GT(std::filesystem::file_size(folder.path() / "foams.csv"), 1000u);
  EXPECT_GT(std::filesystem::file_size(folder.path() / "foams.html"), 1000u);
}

}  // namespace
}  // namespace rebound
