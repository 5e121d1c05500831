#include "comparisons/modules/module_loader.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

TEST(ModuleLoaderTest, ModulesAreLookedForBesideTheProgram) {
  const std::string file = module_file("rebound_fem");
  EXPECT_TRUE(file.starts_with("/"));
  EXPECT_TRUE(file.ends_with("/librebound_fem.so"));
}

TEST(ModuleLoaderTest, ABuildWithoutTheFemTierSaysSo) {
  if (has_fem_tier()) {
    EXPECT_FALSE(fem_tier().versions().empty());
    return;
  }
  const Error error = testing::refusal_of([] { fem_tier(); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(std::string(error.what()).find("REBOUND_FEM"), std::string::npos);
}

}  // namespace
}  // namespace rebound
