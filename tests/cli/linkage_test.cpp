#include <array>
#include <cstdio>
#include <memory>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

/// Loading these costs more than a whole FE impact: only modules may bring them.
TEST(LinkageTest, TheProgramLinksNoFemLibraryDirectlyOrThroughOthers) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen("ldd '" REBOUND_PROGRAM "'", "r"), pclose);
  ASSERT_TRUE(pipe);
  std::string list;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe.get())) list += buffer.data();
  ASSERT_NE(list.find("libc.so"), std::string::npos) << list;  // ldd itself worked
  for (const char* library : {"deal_II", "gmsh", "libmpi", "petsc", "trilinos", "vtk"})
    EXPECT_EQ(list.find(library), std::string::npos) << library << "\n" << list;
}

}  // namespace
}  // namespace rebound::testing
