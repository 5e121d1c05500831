#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class OutputTest : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("a.toml", lumped_file);
    // An unprivileged user must get here and read the file.
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  }
};

TEST_F(OutputTest, AFolderThatCannotBeWrittenIsExitCodeFour) {
  std::filesystem::create_directory(folder.path() / "locked");
  std::filesystem::permissions(folder.path() / "locked", std::filesystem::perms(0555));
  for (const char* out : {"locked", "locked/inner", "a.toml"}) {
    const Outcome outcome =
        rebound({"lumped", "a.toml", "--out", out}, {.privileges = Privileges::drop});
    EXPECT_EQ(outcome.exit_code, 4) << out << outcome.errors;
    EXPECT_NE(outcome.errors.find(out), std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "locked"));
}

TEST_F(OutputTest, AFullDiskIsExitCodeFourAndLeavesNoTrace) {
  const Outcome outcome = rebound({"lumped", "a.toml", "--out", "results"}, {.largest_file = 4096});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.errors;
  EXPECT_FALSE(there("results/trace.csv"));
  EXPECT_FALSE(there("results/result.json"));
}

TEST_F(OutputTest, NoTemporaryFileStays) {
  ASSERT_EQ(rebound({"lumped", "a.toml", "--out", "results"}).exit_code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "results"))
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos) << entry.path();
}

TEST_F(OutputTest, DoctorFindsNothingWrong) {
  const Outcome outcome = rebound({"doctor", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["healthy"], true);
}

}  // namespace
}  // namespace rebound::testing
