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

}  // namespace
}  // namespace rebound
