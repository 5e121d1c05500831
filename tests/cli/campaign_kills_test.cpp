// A campaign that is killed, interrupted, run twice at a time, or has no room left.
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class CampaignKills : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("ball.toml", lumped_file);
    write_campaign(8'000);
  }

  void write_campaign(int count) {
    members = count;
    const std::string key = of_experiments ? "shot[0].speed" : "impact.speed";
    folder.write("many.toml",
                 "schema = 1\nbase = \"ball.toml\"\n[design]\nkind = \"latin-hypercube\"\n"
                 "count = " +
                     std::to_string(count) + "\n[[design.factor]]\nkey = \"" + key +
                     "\"\nlow = \"1 m/s\"\nhigh = \"30 m/s\"\n");
  }

  /// A campaign in the background.
  pid_t start(const std::string& store) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder.path().c_str()) != 0) ::_exit(126);
    ::execl(REBOUND_PROGRAM, REBOUND_PROGRAM, "campaign", "many.toml", "--out", store.c_str(),
            "--json", nullptr);
    ::_exit(127);
  }

  std::string table(const std::string& store, int expected) const {
    const auto outcome =
        rebound({"campaign", "query", "many.toml", "--out", store, "--csv", "t.csv", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["found"], expected);
    return read_whole(folder.path() / "t.csv");
  }

  int found(const std::string& store) const {
    const auto outcome =
        rebound({"campaign", "query", "many.toml", "--out", store, "--csv", "n.csv", "--json"});
    if (outcome.exit_code != 0) return 0;  // killed before there was a store
    return nlohmann::json::parse(outcome.output)["found"];
  }

  /// Kills a campaign `times` times; then it goes on to the end. How often was it killed?
  void kill_again_and_again(int times, int count = 3000) {
    write_campaign(count);
    ASSERT_EQ(rebound({"campaign", "many.toml", "--out", "whole"}).exit_code, 0);
    const std::string whole = table("whole", members);
    std::mt19937 random(7);
    int known = 0, killed = 0;
    for (int round = 0; killed < times; ++round) {
      if (known == members) {  // done: from the beginning
        EXPECT_EQ(table("killed", members), whole);
        std::filesystem::remove_all(folder.path() / "killed");
        known = 0;
      }
      const pid_t child = start("killed");
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 300));
      ::kill(child, SIGKILL);
      int status = 0;
      ::waitpid(child, &status, 0);
      killed += WIFSIGNALED(status);
      const int now = found("killed");
      EXPECT_GE(now, known) << "a kept member is lost";
      known = now;
    }
    ASSERT_EQ(rebound({"campaign", "many.toml", "--out", "killed"}).exit_code, 0);
    EXPECT_EQ(table("killed", members), whole);
  }

  int members = 0;
  bool of_experiments = false;
};

TEST_F(CampaignKills, KilledAtAnyTimeItGoesOnToTheSameBits) {
  kill_again_and_again(20);
}

TEST_F(CampaignKills, KilledAmongExperimentsItGoesOnToTheSameBits) {
  folder.write("ball.toml",
               lumped_file.substr(0, lumped_file.find("[impact]")) +
                   lumped_file.substr(lumped_file.find("[sphere]")) +
                   "[instrument]\nforce_noise = \"5 N\"\n[[shot]]\nspeed = \"5 m/s\"\n");
  of_experiments = true;
  kill_again_and_again(8, 600);
}

class CampaignKillsLong : public CampaignKills {};

TEST_F(CampaignKillsLong, KilledTwoHundredTimesItGoesOnToTheSameBits) {
  kill_again_and_again(200);
}

TEST_F(CampaignKills, TwoAtATimeDoNoHarm) {
  write_campaign(3000);
  ASSERT_EQ(rebound({"campaign", "many.toml", "--out", "whole"}).exit_code, 0);
  const pid_t first = start("shared"), second = start("shared");
  for (const pid_t child : {first, second}) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(table("shared", members), table("whole", members));
}

TEST_F(CampaignKills, InterruptedItKeepsWhatWasRun) {
  int found = 0;
  for (int wait = 100; wait < 4000 && found == 0; wait *= 2) {
    const auto outcome =
        rebound({"campaign", "many.toml", "--out", "store"}, {.interrupt_after_ms = wait});
    ASSERT_EQ(outcome.exit_code, 130) << outcome.errors;
    found = this->found("store");
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, members);
  const auto rest = rebound({"campaign", "many.toml", "--out", "store", "--json"});
  EXPECT_EQ(nlohmann::json::parse(rest.output)["found"], found);
}

TEST_F(CampaignKills, AFileThatMayNotGrowLosesNothing) {
  const auto outcome =
      rebound({"campaign", "many.toml", "--out", "store"}, {.largest_file = 1'000'000});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.errors;
  const int kept = found("store");
  EXPECT_GT(kept, 0);
  const auto rest = rebound({"campaign", "many.toml", "--out", "store", "--json"});
  EXPECT_EQ(nlohmann::json::parse(rest.output)["found"], kept);
  table("store", members);
}

/// A disk of a megabyte and a half in a mount namespace of its own, which needs no privileges
/// where the kernel gives one to every user.
TEST_F(CampaignKills, AFullDiskLosesNothing) {
  const std::string script =
      "set -e; mkdir disk; mount -t tmpfs -o size=1500k tmpfs disk; set +e\n"
      "\"$0\" campaign many.toml --out disk/store; echo run $?\n"
      "mount -o remount,size=100m disk\n"
      "\"$0\" campaign many.toml --out disk/store --json\n";
  const auto outcome =
      run_program({.arguments = {"/usr/bin/unshare", ::geteuid() == 0 ? "-m" : "-Urm", "sh", "-c",
                                 script, REBOUND_PROGRAM},
                   .folder = folder.path()});
  ASSERT_NE(outcome.output.find("run 4"), std::string::npos) << outcome.output << outcome.errors;
  const auto rest = nlohmann::json::parse(outcome.output.substr(outcome.output.find('{')));
  EXPECT_GT(rest["found"], 0);
  EXPECT_EQ(rest["found"].get<int>() + rest["run"].get<int>(), members);
}

}  // namespace
}  // namespace rebound::testing
