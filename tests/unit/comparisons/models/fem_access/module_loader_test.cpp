#include "comparisons/models/fem_access/module_loader.hpp"

#include <gtest/gtest.h>

#include "comparisons/models/installation.hpp"
#include "fem/interface/element_checks.hpp"
#include "fem/interface/interface_stamp.hpp"
#include "fem/interface/material_laws.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

TEST(ModuleLoaderTest, ModulesAreLookedForBesideTheProgram) {
  const std::string file = module_file("rebound_fem").string();
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

TEST(ModuleLoaderTest, AModuleOfAnotherStampIsRefused) {
  if (!has_fem_tier()) return;
  for (const char* entry : {fem_entry_point, material_entry_point, element_checks_entry_point}) {
    const ModuleEntry module{.file = module_file("rebound_fem").string(), .entry_point = entry};
    EXPECT_NE(open_module(module, interface_stamp), nullptr) << entry;
    for (const unsigned long other : {0UL, interface_stamp + 1, ~interface_stamp}) {
      const Error error = testing::refusal_of([&] { open_module(module, other); });
      EXPECT_EQ(error.code(), ExitCode::input_output_failed) << entry;
      EXPECT_NE(std::string(error.what()).find("other sources"), std::string::npos) << entry;
      EXPECT_EQ(error.location().file, module.file);
    }
  }
}

}  // namespace
}  // namespace rebound
