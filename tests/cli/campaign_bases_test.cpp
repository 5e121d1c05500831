// `campaign` over files that are no impacts: syntheses, calibrations, diagnoses.
#include "tests/cli/campaign_bases.hpp"

namespace rebound::testing {
namespace {

TEST_F(CampaignBases, AMemberIsTheExperimentOfItsFile) {
  const auto table = rows(campaign_of("synthesis.toml", "seed", "3, 4"), "store");
  ASSERT_EQ(table.size(), 2u);
  for (const int seed : {3, 4}) {
    const Row& row = table[static_cast<std::size_t>(seed) - 3];
    folder.write("one.toml", replaced(synthesis, "seed = 3", "seed = " + std::to_string(seed)));
    json_of({"synthesize", "one.toml", "--out", "one", "--json"});
    const auto truth = nlohmann::json::parse(read_whole(folder.path() / "one" / "truth.json"));
    EXPECT_EQ(row.at("failure"), "");
    EXPECT_EQ(std::stod(row.at("true_mass_kg")), truth["mass_kg"].get<double>());
    EXPECT_EQ(std::stod(row.at("true_force_gain")), truth["force_gain"].get<double>());
    const std::string manifest = read_whole(folder.path() / "one" / "data" / "dataset.toml");
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string shot = "shot-0" + std::to_string(i + 1) + ".";
      EXPECT_EQ(std::stod(row.at(shot + "restitution")),
                truth["shots"][i]["restitution"].get<double>());
      EXPECT_EQ(std::stod(row.at(shot + "speed_m_s")),
                truth["shots"][i]["speed_m_s"].get<double>());
      EXPECT_GT(std::stod(row.at(shot + "measured_peak_force_N")), 0.0);
    }
    const std::string written = "restitution = ";
    EXPECT_EQ(std::stod(row.at("shot-01.measured_restitution")),
              std::stod(manifest.substr(manifest.find(written) + written.size())));
    EXPECT_FALSE(row.contains("shot-03.measured_restitution"));
    EXPECT_TRUE(row.contains("shot-02.measured_contact_time_s"));
  }
  EXPECT_NE(table[0].at("shot-01.measured_peak_force_N"),
            table[1].at("shot-01.measured_peak_force_N"));
}

TEST_F(CampaignBases, AMemberIsTheCalibrationOfItsFile) {
  json_of({"synthesize", "synthesis.toml", "--out", "made", "--json"});
  const std::string calibration =
      "schema = 1\nlaw = \"kuwabara-kono\"\ntip_margin = 0.05\n[[reference]]\nfolder = "
      "\"made/data\"\n";
  folder.write("calibration.toml", calibration);
  const std::string text = campaign_of("calibration.toml", "tip_margin", "0.05, 0.2");
  const auto table = rows(text, "store");
  ASSERT_EQ(table.size(), 2u);
  const auto single = json_of({"calibrate", "calibration.toml", "--json"});
  for (const auto& estimate : single["estimates"]) {
    const std::string name = estimate["name"];
    EXPECT_EQ(std::stod(table[0].at(name)), estimate["value"].get<double>()) << name;
    EXPECT_EQ(std::stod(table[0].at(name + ".low")), estimate["interval"][0].get<double>());
    EXPECT_NE(table[0].at(name), table[1].at(name)) << name;
  }
  EXPECT_EQ(std::stod(table[0].at("cost_after")), single["cost_after"].get<double>());
  EXPECT_EQ(table[0].at("converged"), "1");
  // Other data are other members, though no file of the campaign has changed.
  folder.write("synthesis.toml", replaced(synthesis, "seed = 3", "seed = 4"));
  json_of({"synthesize", "synthesis.toml", "--out", "made", "--json"});
  const auto again = json_of({"campaign", "campaign.toml", "--out", "store", "--json"});
  EXPECT_EQ(again["found"], 0);
  EXPECT_EQ(again["run"], 2);
}

TEST_F(CampaignBases, AMemberIsTheDiagnosisOfItsExperiment) {
  folder.write("diagnosis.toml",
               "schema = 1\nbelieved = \"ball.toml\"\nexperiment = \"synthesis.toml\"\n");
  const auto table =
      rows(campaign_of("diagnosis.toml", "experiment.model.effect[0].size", "0.4, 0.8"), "store");
  ASSERT_EQ(table.size(), 2u);
  json_of({"synthesize", "synthesis.toml", "--out", "made", "--json"});
  const auto single =
      json_of({"diagnose", "made/data", "--model", "ball.toml", "--no-fem", "--json"});
  EXPECT_EQ(table[0].at("verdict"), single["verdict"].dump());
  EXPECT_EQ(table[0].at("verdict"), "\"missing\"");
  EXPECT_EQ(table[0].at("name"), single["effects"][0]["name"].dump());
  EXPECT_EQ(std::stod(table[0].at("size")), single["effects"][0]["size"].get<double>());
  EXPECT_EQ(std::stod(table[0].at("gap_after")), single["gap"]["after"].get<double>());
  EXPECT_GT(std::stod(table[1].at("size")), std::stod(table[0].at("size")));
  // The same data in a folder give the same, and FE takes nothing of a name that is right.
  folder.write("diagnosis.toml",
               "schema = 1\nbelieved = \"ball.toml\"\ndata = [\"made/data\"]\nseed = 1\n"
               "ask_fem = true\n");
  const auto stored = rows(campaign_of("diagnosis.toml", "seed", "1"), "stored");
  ASSERT_EQ(stored.size(), 1u);
  EXPECT_EQ(stored[0].at("size"), table[0].at("size"));
}

TEST_F(CampaignBases, AMemberThatIsRefusedIsKeptWithItsReason) {
  const auto table =
      rows(campaign_of("synthesis.toml", "sphere.diameter", "\"66.2 mm\", \"400 mm\""), "store");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].at("failure"), "");
  EXPECT_NE(table[1].at("failure").find("density"), std::string::npos);
  EXPECT_EQ(table[1].at("shot-01.restitution"), "");
}

TEST_F(CampaignBases, BadBasesAreRefusedWithTheirPlace) {
  EXPECT_EQ(refusal(campaign_of("synthesis.toml", "impact.speed", "\"5 m/s\""))["key"],
            "design.factor[0].key");
  EXPECT_EQ(refusal(campaign_of("synthesis.toml", "sampling.rate", "\"5 kHz\""))["key"],
            "design.factor[0].key");  // not given there
  folder.write("blind.toml",
               replaced(synthesis, "speed = \"25 m/s\"", "speed = \"25 m/s\"\nhistory = false"));
  const auto blind = refusal(campaign_of("blind.toml", "seed", "1"));
  EXPECT_NE(blind["file"].dump().find("blind.toml"), std::string::npos);
  EXPECT_EQ(blind["key"], "shot[2]");
  folder.write("nothing.toml", "schema = 1\nbelieved = \"ball.toml\"\n");
  EXPECT_EQ(refusal(campaign_of("nothing.toml", "seed", "1"))["key"], "data");
  folder.write("both.toml",
               "schema = 1\nbelieved = \"ball.toml\"\ndata = [\"x\"]\nexperiment = \"y\"\n");
  EXPECT_EQ(refusal(campaign_of("both.toml", "seed", "1"))["key"], "experiment");
  folder.write("law.toml", "schema = 1\nlaw = \"hertzian\"\n[[reference]]\nfolder = \"x\"\n");
  const auto law = refusal(campaign_of("law.toml", "tip_margin", "0.1"));
  EXPECT_EQ(law["key"], "law");
  EXPECT_NE(law["file"].dump().find("law.toml"), std::string::npos);
}

}  // namespace
}  // namespace rebound::testing
