// Every include of the tree against one table of allowed directions, and the
// table against lines that break it.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/structure/include_rules.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound::testing {
namespace {

const std::filesystem::path source_folder = REBOUND_SOURCE_FOLDER;
const IncludeRules& rules() {
  static const IncludeRules read(source_folder / "tests/structure/allowed_includes.txt");
  return read;
}

TEST(IncludeTest, EveryIncludeOfTheTreeGoesAnAllowedWay) {
  const IncludeRules::Report report = rules().check(source_folder);
  for (const std::string& violation : report.violations) ADD_FAILURE() << violation;
  // The walk found the tree: fewer would mean that it looked elsewhere.
  EXPECT_GT(report.files, 500);
  EXPECT_GT(report.includes, 3000);
  RecordProperty("includes_checked", report.includes);
  std::printf("%d includes of %d files checked\n", report.includes, report.files);
}

/// A tree of two files, the second including `line`.
std::vector<std::string> violations_of(const std::string& file, const std::string& line) {
  const TemporaryFolder tree;
  for (const std::string& name :
       {std::string("lumped/laws/known.hpp"), std::string("fem/interface/known.hpp"),
        std::string("comparisons/app/known.hpp"), file}) {
    std::filesystem::create_directories((tree.path() / name).parent_path());
    std::ofstream(tree.path() / name) << (name == file ? "#pragma once\n" + line + "\n" : "");
  }
  return rules().check(tree.path()).violations;
}

TEST(IncludeTest, ASeededLineThatBreaksTheDirectionIsSeen) {
  EXPECT_TRUE(violations_of("comparisons/io/a.cpp", "#include \"lumped/laws/known.hpp\"").empty());
  EXPECT_EQ(violations_of("fem/kernel/a.cpp", "#include \"lumped/laws/known.hpp\""),
            std::vector<std::string>{"fem/kernel/a.cpp:2: fem/kernel may not include "
                                     "lumped/laws/known.hpp"});
  EXPECT_EQ(violations_of("lumped/laws/a.hpp", "#include \"fem/interface/known.hpp\"").size(), 1u);
  EXPECT_EQ(violations_of("comparisons/io/a.cpp", "#include \"comparisons/app/known.hpp\"").size(),
            1u);
  EXPECT_EQ(violations_of("comparisons/io/a.cpp", "#include <deal.II/base/config.h>").size(), 1u);
  EXPECT_EQ(violations_of("comparisons/io/a.cpp", "#include \"lumped/laws/gone.hpp\"").size(), 1u);
  EXPECT_EQ(violations_of("elsewhere/a.cpp", "#include <vector>").size(), 1u);
}

}  // namespace
}  // namespace rebound::testing
