#include "comparisons/io/results/digest.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// Source: FIPS 180-4 example values.
TEST(DigestTest, PublishedValues) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

// A folder is its files: names, places and bytes, whatever the order in which they were written.
TEST(DigestTest, OfAFolderSeesNamesAndBytes) {
  const testing::TemporaryFolder first, second;
  std::filesystem::create_directory(first.path() / "below");
  first.write("a.csv", "1");
  first.write("below/b.csv", "2");
  std::filesystem::create_directory(second.path() / "below");
  second.write("below/b.csv", "2");
  second.write("a.csv", "1");
  const std::string whole = digest_of_folder(first.path());
  EXPECT_EQ(digest_of_folder(second.path()), whole);
  std::filesystem::rename(second.path() / "a.csv", second.path() / "A.csv");
  EXPECT_NE(digest_of_folder(second.path()), whole);
  first.write("a.csv", "3");
  EXPECT_NE(digest_of_folder(first.path()), whole);
}

}  // namespace
}  // namespace rebound
