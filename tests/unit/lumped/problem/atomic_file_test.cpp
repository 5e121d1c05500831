#include "lumped/problem/atomic_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <iterator>

#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::read_whole;
using testing::refusal_of;
using testing::TemporaryFolder;

std::size_t entries(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(AtomicFileTest, ReplacesWholeFilesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  write_file_atomically(file, "first, longer");
  write_file_atomically(file, "second");
  EXPECT_EQ(read_whole(file), "second");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(AtomicFileTest, AFailureKeepsTheOldFileAndCleansUp) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "taken");  // a rename onto it must fail
  const Error error = refusal_of([&] { write_file_atomically(folder.path() / "taken", "text"); });
  EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  EXPECT_EQ(error.location().file, (folder.path() / "taken").string());
  EXPECT_EQ(entries(folder.path()), 1u);
}

/// A limit on the size of files stops a write half way, as a full disk does.
TEST(AtomicFileTest, AWriteThatStopsHalfWayKeepsTheOldFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  write_file_atomically(file, "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 4096;
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const Error error = refusal_of([&] { write_file_atomically(file, std::string(100000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  EXPECT_EQ(read_whole(file), "old");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(AtomicFileTest, FoldersAreMadeAndProvedWritable) {
  const TemporaryFolder folder;
  make_writable_folder(folder.path() / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "a" / "b"));
  folder.write("file", "");
  EXPECT_EQ(refusal_of([&] { make_writable_folder(folder.path() / "file"); }).code(),
            ExitCode::input_output_failed);
}

}  // namespace
}  // namespace rebound
