#include "comparisons/studies/campaign/content_bytes.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

LumpedImpactFile file() {
  LumpedImpactFile made;
  made.problem = test::typical_problem("hunt-crossley");
  made.effects = {{.name = "gravity", .size = 1.0, .parameters = {}}};
  return made;
}

TEST(ContentBytesTest, TheSameContentHasTheSameBytes) {
  EXPECT_EQ(content_bytes(file()), content_bytes(file()));
  LumpedImpactFile negative_zero = file(), zero = file();
  negative_zero.effects[0].size = -0.0;
  zero.effects[0].size = 0.0;
  EXPECT_EQ(content_bytes(negative_zero), content_bytes(zero));
}

TEST(ContentBytesTest, EveryChangeIsSeen) {
  const std::string before = content_bytes(file());
  const auto seen = [&](auto&& change) {
    LumpedImpactFile changed = file();
    change(changed);
    return content_bytes(changed) != before;
  };
  EXPECT_TRUE(seen([](auto& f) { f.problem.impact.speed *= 1.0 + 1e-15; }));
  EXPECT_TRUE(seen([](auto& f) { f.problem.impact.separation = SeparationRule::zero_deflection; }));
  EXPECT_TRUE(seen([](auto& f) { f.problem.sphere.mass *= 2.0; }));
  EXPECT_TRUE(seen([](auto& f) { std::swap(f.problem.sphere.mass, f.problem.sphere.diameter); }));
  EXPECT_TRUE(seen([](auto& f) { f.problem.model.parameters["damping"] *= 2.0; }));
  EXPECT_TRUE(seen([](auto& f) {
    std::swap(f.problem.model.parameters["damping"], f.problem.model.parameters["stiffness"]);
  }));
  EXPECT_TRUE(seen([](auto& f) { f.effects.clear(); }));
  EXPECT_TRUE(seen([](auto& f) { f.effects.push_back(f.effects[0]); }));
}

TEST(ContentBytesTest, NumbersThatAreSetOnTheWayAreThoseThatEachNumberSets) {
  LumpedImpactFile plain = file();
  std::vector<std::string> paths;
  const EachNumber::Look name = [&](const std::string& path, const Key&, double&) {
    if (path != "schema") paths.push_back(path);  // which no record keeps
  };
  EachNumber visitor(name);
  describe(static_cast<Visitor&>(visitor), plain);
  EXPECT_GT(paths.size(), 6u);
  for (const std::string& wanted : paths) {
    int shown = 0;
    const EachNumber::Look change = [&](const std::string& path, const Key&, double& value) {
      if (path != wanted) return;
      value = 2.0 * value + 3.0;
      ++shown;
    };
    LumpedImpactFile first = file(), together = file();
    EachNumber setter(change);
    describe(static_cast<Visitor&>(setter), first);
    EXPECT_EQ(content_bytes(together, change), content_bytes(first)) << wanted;
    EXPECT_EQ(content_bytes(together), content_bytes(first)) << wanted;
    EXPECT_EQ(shown, 2) << wanted;
  }
}

}  // namespace
}  // namespace rebound
