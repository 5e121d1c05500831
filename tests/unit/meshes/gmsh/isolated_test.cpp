// A process of its own keeps crashes, files, output and memory to itself.
#include "meshes/gmsh/isolated.hpp"

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <limits>
#include <vector>

#include "meshes/gmsh/mesh_bytes.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

TEST(IsolatedTest, ReturnsWhatWasMade) {
  const std::string much(3'000'000, 'x');
  EXPECT_EQ(isolated([&] { return much; }, {}, {}), much);
  EXPECT_EQ(isolated([] { return std::string(); }, {}, {}), "");
}

TEST(IsolatedTest, AnErrorCrossesWhole) {
  const Error error = refusal_of([] {
    isolated(
        []() -> std::string {
          throw Error(ExitCode::solver_failed, "why",
                      {.file = "f", .line = 3, .key = "k", .value = "v", .allowed = "a"});
        },
        {}, {});
  });
  EXPECT_EQ(error.code(), ExitCode::solver_failed);
  EXPECT_STREQ(error.what(), "why");
  EXPECT_EQ(error.location().file + error.location().key, "fk");
  EXPECT_EQ(error.location().value + error.location().allowed, "va");
  EXPECT_EQ(error.location().line, 3);
}

TEST(IsolatedTest, ACrashAnEndAndTooMuchMemoryAreErrors) {
  const auto refused = [](const std::function<std::string()>& work) {
    return std::string(refusal_of([&] { isolated(work, {.memory = 1e8}, {}); }).what());
  };
  EXPECT_NE(refused([] {
              std::raise(SIGSEGV);
              return std::string();
            }).find("crashed"),
            std::string::npos);
  EXPECT_NE(refused([]() -> std::string { ::_exit(0); }).find("ended"), std::string::npos);
  EXPECT_NE(refused([] {
              return std::string(std::vector<char>(std::size_t{1} << 40, 'x').data(), 1);
            }).find("memory"),
            std::string::npos);
}

TEST(IsolatedTest, EndlessWorkIsAnError) {
  const Error error = refusal_of([] {
    isolated(
        [] {
          for (volatile int turns = 0;; turns = turns + 1) {
          }
          return std::string();
        },
        {.seconds = 0.5}, {});
  });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(std::string(error.what()).find("more than 1 s of processor time"), std::string::npos)
      << error.what();
}

TEST(IsolatedTest, WritesNoFileAndPrintsNothing) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "made";
  ::testing::internal::CaptureStdout();
  isolated(
      [&] {
        std::printf("seen?\n");
        std::fflush(stdout);
        std::ofstream(file) << "text";
        return std::string();
      },
      {}, {});
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::read_whole(file), "");
}

TEST(IsolatedTest, AnInterruptionEndsIt) {
  int asked = 0;
  const RunControl control{.interrupted = [&] { return ++asked > 2; }, .progress = {}};
  const Error error = refusal_of([&] {
    isolated(
        [] {
          for (;;) ::pause();
          return std::string();
        },
        {}, control);
  });
  EXPECT_EQ(error.code(), ExitCode::interrupted);
}

TEST(IsolatedTest, CtrlCThatReachesItAloneIsAnInterruption) {
  const Error error = refusal_of([] {
    isolated(
        [] {
          std::raise(SIGINT);
          return std::string();
        },
        {}, {});
  });
  EXPECT_EQ(error.code(), ExitCode::interrupted);
}

TEST(MeshBytesTest, KeepEveryBit) {
  const Mesh mesh{.vertices = {{0.1, -0.0}, {1.0 / 3.0, std::numeric_limits<double>::min()}},
                  .cells = {{0, 1, 2, 3}},
                  .axis_edges = {{4, 5}},
                  .contact_edges = {},
                  .regions = {-1},
                  .region_names = {"a", ""}};
  const std::string bytes = bytes_of(mesh);
  const Mesh back = mesh_of(bytes);
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_TRUE(std::signbit(back.vertices[0][1]));
  EXPECT_EQ(back.cells, mesh.cells);
  EXPECT_EQ(back.axis_edges, mesh.axis_edges);
  EXPECT_EQ(back.contact_edges, mesh.contact_edges);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_EQ(back.region_names, mesh.region_names);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(mesh_of(std::string_view(bytes).substr(0, length)), Error) << length;
}

}  // namespace
}  // namespace rebound
