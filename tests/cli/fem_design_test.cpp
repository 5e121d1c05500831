// `design` around a believed FE model.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class FemDesign : public ProgramTest {};

TEST_F(FemDesign, SaysWhatWouldBeFoundBesideAnFeModel) {
  folder.write("plan.toml", R"(schema = 1
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 600
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
modulus = "long-term"
[[model.material.branch]]
ratio = 1.0
relaxation_time = "0.1 ms"
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
[[shot]]
speed = "15 m/s"
speed_uncertainty = "0.05 m/s"
)");
  const auto outcome = rebound({"design", "plan.toml", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["shots"], 1);
  EXPECT_GT(json["changes"].size(), 3u);
  const auto left_out = json["left_out"].get<std::vector<std::string>>();
  EXPECT_NE(std::find(left_out.begin(), left_out.end(), "linear-dashpot"), left_out.end());
  int found = 0;
  for (const auto& effect : json["effects"]) {
    EXPECT_EQ(std::find(left_out.begin(), left_out.end(), effect["name"]), left_out.end());
    if (!effect["found"].is_null()) ++found;
  }
  EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace rebound::testing
