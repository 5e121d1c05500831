#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "comparisons/discrepancy/trials/generator/maxwell_series.hpp"
#include "comparisons/discrepancy/trials/generator/trial_files.hpp"

namespace trials {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// All files below a folder by their names.
std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  return files;
}

class TrialBytes : public ::testing::Test {
 protected:
  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ::testing::UnitTest::GetInstance()->current_test_info()->name();
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, std::uint64_t seed, const std::string& only) {
    TrialFolder folder(folder_ / name);
    for (int number = 1; number <= 2; ++number)
      folder.add(make_trial({.seed = seed, .set = "test", .number = number, .only = only}));
  }
};

TEST_F(TrialBytes, SameSeedSameDataOtherSeedOtherData) {
  write("a", 5, "elastic");
  write("b", 5, "elastic");
  write("c", 6, "elastic");
  EXPECT_GT(files_below(folder_ / "a/trials").size(), 6u);
  EXPECT_EQ(files_below(folder_ / "a/trials"), files_below(folder_ / "b/trials"));
  EXPECT_NE(files_below(folder_ / "a/trials"), files_below(folder_ / "c/trials"));
}

TEST_F(TrialBytes, TruthsDifferByTheirNonceAlone) {
  write("a", 5, "null");
  write("b", 5, "null");
  const std::regex nonce("\"nonce\": \"[0-9a-f]{64}\"");
  const std::string a = bytes_of(folder_ / "a/truth/0001.json");
  const std::string b = bytes_of(folder_ / "b/truth/0001.json");
  EXPECT_NE(a, b);
  EXPECT_TRUE(std::regex_search(a, nonce));
  EXPECT_EQ(std::regex_replace(a, nonce, ""), std::regex_replace(b, nonce, ""));
}

TEST_F(TrialBytes, SealsMatchAndNoTemporaryFileStays) {
  write("a", 5, "pair");
  std::ifstream seals(folder_ / "a/sealed.txt");
  int count = 0;
  for (std::string hash, file; seals >> hash >> file; ++count)
    EXPECT_EQ(hash, sha256(bytes_of(folder_ / "a" / file)));
  EXPECT_EQ(count, 2);
  for (const auto& [name, bytes] : files_below(folder_)) EXPECT_FALSE(name.ends_with(".tmp"));
}

/// The published test vector of FIPS 180-4.
TEST(TrialSeal, KnownHash) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(TrialSeal, DataSayNothingOfWhatIsHidden) {
  const Trial trial = make_trial({.seed = 3, .set = "test", .number = 1, .only = "hum"});
  for (const std::string& text : {dataset_text(trial), model_text(trial)})
    for (const char* word : {"hum", "measurement", "seed", "kind", "null"})
      EXPECT_EQ(text.find(word), std::string::npos) << word;
}

TEST(TrialDraw, ATrialDoesNotDependOnTheOthers) {
  const TrialRequest request{.seed = 9, .set = "test", .number = 7, .only = "null"};
  EXPECT_EQ(dataset_text(make_trial(request)), dataset_text(make_trial(request)));
  TrialRequest other = request;
  other.set = "another";
  EXPECT_NE(csv_text(make_trial(request).shots[0]), csv_text(make_trial(other).shots[0]));
}

TEST(TrialDraw, ANullHasNothingVisible) {
  for (int number = 1; number <= 5; ++number)
    EXPECT_LT(
        make_trial({.seed = 2, .set = "test", .number = number, .only = "null"}).visible_chi_square,
        0.05);
}

TEST(TrialDraw, ExperimentsAreAsPromised) {
  for (int number = 1; number <= 50; ++number) {
    const Trial trial = draw_experiment({.seed = 2, .set = "test", .number = number});
    EXPECT_GE(trial.scales.largest_speed, 2.99 * trial.scales.smallest_speed);
    EXPECT_GE(trial.scales.smallest_speed, 2.0);
    EXPECT_LE(trial.scales.largest_speed, 30.0);
    EXPECT_GE(trial.samples_before, 60);
    EXPECT_LE(std::abs(std::log(trial.believed_stiffness / trial.ball.stiffness)), std::log(1.5));
    const double damping = trial.ball.stiffness * trial.ball.damping;
    EXPECT_LE(std::abs(std::log(trial.believed_damping / damping)), std::log(2.0));
  }
}

TEST(TrialNoise, EveryColourHasTheDeviationAskedFor) {
  Random random({.seed = 4, .set = "test"});
  for (const Noise noise :
       {Noise{NoiseColour::white}, Noise{NoiseColour::autoregressive, 0.7},
        Noise{NoiseColour::band_limited, 0.05}, Noise{NoiseColour::one_over_f}}) {
    Noise wanted = noise;
    wanted.deviation = 3.0;
    double square = 0.0;
    const int count = 400000;
    for (const double value : draw_noise(wanted, count, random)) square += value * value;
    EXPECT_NEAR(std::sqrt(square / count), 3.0, 0.15) << name_of(noise.colour);
  }
}

TEST(TrialMaxwell, BranchesFollowAPowerLaw) {
  const auto wanted = [](double t) { return std::pow(t / 1e-3, -0.3); };
  const auto branches = branches_like(wanted, 1e-5, 1e-2);
  for (const double t : {3e-5, 3e-4, 3e-3})
    EXPECT_NEAR(relaxation_of(branches, t) / wanted(t), 1.0, 0.05);
}

/// The room includes itself and libraries: no header of what it is to test.
TEST(TrialRoom, IncludesNothingOfTheProject) {
  const std::regex include("\\s*#\\s*include\\s*\"([^\"]+)\"");
  int sources = 0;
  for (const auto& entry : fs::directory_iterator(TRIAL_GENERATOR_ROOM)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    ++sources;
    std::ifstream stream(entry.path());
    std::smatch match;
    for (std::string line; std::getline(stream, line);) {
      if (!std::regex_search(line, match, include)) continue;
      EXPECT_TRUE(match[1].str().starts_with("comparisons/discrepancy/trials/generator/"))
          << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(sources, 20);
}

}  // namespace
}  // namespace trials
