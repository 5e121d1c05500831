// What a ball of FE is made of, beside a believed lumped model, where the noise is small enough to
// show it: none of it is an effect.
#include <filesystem>
#include <regex>
#include <string>

#include "tests/cli/diagnosed_experiment.hpp"

namespace rebound::testing {
namespace {

std::string experiment_of(const std::string& branches) {
  return R"(schema = 1
name = "own"
seed = 5
[sphere]
mass = "92 g"
diameter = "65.9 mm"
[model]
tier = "fem"
cells = 3000
[model.material]
modulus = "long-term"
elastic = "neo-hookean"
youngs_modulus = "11 MPa"
poisson_ratio = 0.4
)" + branches +
         R"([instrument]
force_noise = "2 N"
force_gain_uncertainty = 0.017
[sampling]
rate = "100 kHz"
before = "0.5 ms"
after = "2 ms"
[[shot]]
speed = "4.3 m/s"
speed_uncertainty = "0.03 m/s"
[[shot]]
speed = "9.2 m/s"
speed_uncertainty = "0.06 m/s"
[[shot]]
speed = "19.6 m/s"
speed_uncertainty = "0.13 m/s"
)";
}

class OwnBallOfFem : public DiagnosedExperiment {
 protected:
  void expect_nothing_missing(const std::string& branches) {
    const auto found = diagnosis_of(experiment_of(branches), believed_lumped);
    EXPECT_EQ(found["verdict"], "agrees") << found["warnings"];
    EXPECT_LT(found["gap"]["before"].get<double>(), 1.2);
    EXPECT_LT(found["gap"]["held_out_before"].get<double>(), 1.3);
  }
};

/// As one branch of all stress a ball of the deviator leaves a gap of 8 to 77.
TEST_F(OwnBallOfFem, MayHaveABranchOfTheDeviatorAlone) {
  expect_nothing_missing(R"([[model.material.branch]]
ratio = 1.1
relaxation_time = "0.06 ms"
relaxes = "deviator"
)");
}

TEST_F(OwnBallOfFem, MayHaveTwoBranches) {
  expect_nothing_missing(R"([[model.material.branch]]
ratio = 0.3
relaxation_time = "0.05 ms"
[[model.material.branch]]
ratio = 0.25
relaxation_time = "0.15 ms"
)");
}

/// Its relaxation explains the data, and no ball of FE with nothing hidden comes near them: other
/// kinds of it, which leave a little less, are not tried.
TEST_F(OwnBallOfFem, IsSearchedNoFurtherWhereTheLawExplainsMore) {
  const std::filesystem::path experiments = REBOUND_EXPERIMENTS_FOLDER;
  const auto found = diagnosis_of(read_whole(experiments / "lumped-relaxation.toml"),
                                  read_whole(experiments / "believed.toml"));
  EXPECT_EQ(found["family"], "memory");
  ASSERT_EQ(found["fem_balls"].size(), 1u);
  EXPECT_TRUE(std::regex_match(found["fem_balls"][0].get<std::string>(),
                               std::regex("neo-hookean, E [^,]*, ν [^,]*, branch [^,]*")))
      << found["fem_balls"];
}

}  // namespace
}  // namespace rebound::testing
