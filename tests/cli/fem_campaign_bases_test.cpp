// `campaign` over files that need the FE tier: its experiments, and fits of its materials.
#include "tests/cli/campaign_bases.hpp"

namespace rebound::testing {
namespace {

using FemCampaignBases = CampaignBases;

TEST_F(FemCampaignBases, ExperimentsOfFiniteElementsRunToo) {
  folder.write("fem.toml", R"(schema = 1
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 60
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
[[shot]]
speed = "10 m/s"
)");
  const auto table =
      rows(campaign_of("fem.toml", "model.material.youngs_modulus", "\"10 MPa\", \"20 MPa\""), "f");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_LT(std::stod(table[1].at("shot-01.contact_time_s")),
            std::stod(table[0].at("shot-01.contact_time_s")));
}

TEST_F(FemCampaignBases, AMemberIsTheCalibrationOfAMaterial) {
  json_of({"synthesize", "synthesis.toml", "--out", "made", "--json"});
  folder.write("fem.toml", fem_file);
  const std::string calibration =
      "schema = 1\ntier = \"fem\"\nmodel = \"fem.toml\"\nfree = [\"youngs_modulus\"]\n"
      "folders = [\"made/data\"]\nstarts = 1\ncontact_time_uncertainty = 0.01\n";
  folder.write("material.toml", calibration);
  const std::string key = "contact_time_uncertainty";
  const auto table = rows(campaign_of("material.toml", key, "0.01, 0.03"), "store");
  ASSERT_EQ(table.size(), 2u);
  for (const char* value : {"0.01", "0.03"}) {
    folder.write("material.toml", replaced(calibration, "0.01", value));
    const auto single = json_of({"calibrate", "material.toml", "--json"});
    const Row& row = table[std::string(value) == "0.03"];
    EXPECT_EQ(std::stod(row.at("cost_after")), single["cost_after"].get<double>()) << value;
    EXPECT_EQ(std::stod(row.at(single["estimates"][0]["name"])),
              single["estimates"][0]["value"].get<double>());
  }
  EXPECT_NE(table[0].at("cost_after"), table[1].at("cost_after"));
}

}  // namespace
}  // namespace rebound::testing
