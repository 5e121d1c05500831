#include "comparisons/modules/module_loader.hpp"

#include "comparisons/modules/mesh_cache.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

TEST(ModuleLoaderTest, ModulesAreLookedForBesideTheProgram) {
  const std::string file = module_file("rebound_fem");
  EXPECT_TRUE(file.starts_with("/"));
  EXPECT_TRUE(file.ends_with("/librebound_fem.so"));
}

TEST(ModuleLoaderTest, ABuildWithoutTheFemTierSaysSo) {
  if (has_modules()) {
    EXPECT_FALSE(mesh_generator().versions().empty());
    return;
  }
  const Error error = testing::refusal_of([] { fem_tier(); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(std::string(error.what()).find("REBOUND_FEM"), std::string::npos);
}

TEST(CacheFolderTest, TheNearestVariableDecides) {
  ::setenv("HOME", "/h", 1);
  ::unsetenv("REBOUND_CACHE");
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(cache_folder(), "/h/.cache/rebound");
  ::setenv("XDG_CACHE_HOME", "/x", 1);
  EXPECT_EQ(cache_folder(), "/x/rebound");
  ::setenv("REBOUND_CACHE", "/r", 1);
  EXPECT_EQ(cache_folder(), "/r");
}

}  // namespace
}  // namespace rebound
