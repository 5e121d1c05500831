// Scripts must not reach beyond the geometry.
#include "meshes/gmsh/input_file.hpp"
#include "fem/interface/interface_stamp.hpp"

#include <array>

#include "meshes/gmsh/interface.hpp"
#include "tests/support/mesh_files.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

extern "C" const rebound::GmshModule* rebound_gmsh_module(unsigned long stamp);

namespace rebound {
namespace {

class Script : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
};

TEST_F(Script, WordsThatReachBeyondTheGeometryAreRefusedWithTheirLine) {
  const auto made = (folder_.path() / "made").string();
  const std::array statements = {"SystemCall \"touch " + made + "\";",
                                 "NonBlockingSystemCall \"touch " + made + "\";",
                                 "Save \"" + made + "\";",
                                 "Print \"" + made + "\";",
                                 "Printf(\"x\") > \"" + made + "\";",
                                 std::string("Merge \"other.geo\";"),
                                 std::string("Include \"other.geo\";"),
                                 std::string("OnelabRun(\"a\", \"b\");"),
                                 std::string("Plugin(MathEval).Run;"),
                                 std::string("x = GetValue(\"how many?\", 1);"),
                                 std::string("General.Terminal = 1;"),
                                 std::string("Exit;"),
                                 std::string("/* */Save\"a\";")};
  for (const std::string& statement : statements) {
    const auto file = folder_.write("a.geo", testing::ball_geo + statement + "\n").string();
    const Error error =
        testing::refusal_of([&] { rebound_gmsh_module(interface_stamp)->read(file, 1000, {}); });
    EXPECT_EQ(error.code(), ExitCode::bad_input) << statement;
    EXPECT_EQ(error.location().file, file);
    EXPECT_EQ(error.location().line, 13) << statement << error.what();
    EXPECT_FALSE(std::filesystem::exists(made)) << statement;
  }
}

TEST_F(Script, WordsThatOnlyContainOneAreNot) {
  const auto file = folder_.write("a.geo", "SaveMe = 1; my_Print = 2; Generally = 3;\n").string();
  EXPECT_EQ(read_input(file).kind, InputKind::script);
}

TEST_F(Script, AMemoryFileHoldsTheBytes) {
  const std::string bytes("a\0b\n", 4);
  const MemoryFile file(bytes);
  EXPECT_EQ(testing::read_whole(file.path()), bytes);
}

}  // namespace
}  // namespace rebound
