// Whoever looks into a store while it is written to must leave its log alone: another process sees
// that it is in use.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "comparisons/io/result_store/result_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// Does another process find SQLite's shared lock on the file? A process does not see its own.
bool is_in_use(const std::filesystem::path& file) {
  const pid_t other = ::fork();
  if (other == 0) {
    struct flock lock = {};  // bytes of SQLite's file format
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = 0x40000000 + 2;
    lock.l_len = 510;
    const int descriptor = ::open(file.c_str(), O_RDWR);
    const bool asked = descriptor >= 0 && ::fcntl(descriptor, F_GETLK, &lock) == 0;
    ::_exit(asked && lock.l_type != F_UNLCK ? 0 : 1);
  }
  int status = 1;
  ::waitpid(other, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(StoreLocksTest, AStoreThatIsReadAndWrittenStaysLocked) {
  const testing::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "store.sqlite";
  { ResultStore made(file, ResultStore::Access::write, "one"); }
  EXPECT_FALSE(is_in_use(file));
  ResultStore reading(file);
  EXPECT_TRUE(is_in_use(file));
  ResultStore writing(file, ResultStore::Access::write, "one");
  EXPECT_TRUE(is_in_use(file)) << "what is kept now is lost once another process has looked in";
}

}  // namespace
}  // namespace rebound
