// `calibrate` on the material of the FE tier, and `drop` from what it found.
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class CalibrateMaterial : public ProgramTest {
 protected:
  void SetUp() override {
    // Cells enough for one mesh at both speeds: coarser ones are graded for each, and what is
    // found then holds their errors too (5 % of the ratio at 60 cells).
    const std::string ball = replaced(fem_file, "cells = 60", "cells = 1000");
    for (const char* speed : {"5", "20"}) {
      folder.write("truth.toml", replaced(ball, "15 m/s", std::string(speed) + " m/s"));
      ASSERT_EQ(rebound({"fem", "truth.toml", "--out", std::string("at-") + speed}).exit_code, 0);
    }
    folder.write("start.toml", replaced(replaced(ball, "ratio = 0.3", "ratio = 0.15"), "\"0.3 ms\"",
                                        "\"0.5 ms\""));
    folder.write("material.toml", file_);
  }
  const std::string file_ =
      "schema = 1\ntier = \"fem\"\nmodel = \"start.toml\"\nstarts = 2\n"
      "free = [\"branch[0].ratio\", \"branch[0].relaxation_time\"]\n"
      "folders = [\"at-5\", \"at-20\"]\n";
};

TEST_F(CalibrateMaterial, RecoversABranchAndTheDropCarriesItsError) {
  const Outcome outcome = rebound({"calibrate", "material.toml", "--json", "--out", "found"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["tier"], "fem");
  EXPECT_NEAR(json["estimates"][0]["value"].get<double>(), 0.3, 0.02);
  EXPECT_NEAR(json["estimates"][1]["value"].get<double>(), 0.3e-3, 0.04e-3);
  EXPECT_EQ(json["references"].size(), 2u);
  EXPECT_FALSE(there("found/checkpoint.json"));
  EXPECT_EQ(rebound({"fem", "found/calibrated.toml"}).exit_code, 0);
  const Outcome drop = rebound({"drop", "found", "--json"});
  ASSERT_EQ(drop.exit_code, 0) << drop.errors;
  const auto fall = nlohmann::json::parse(drop.output);
  const double e = fall["restitution"], low = fall["interval"][0], high = fall["interval"][1];
  EXPECT_LT(low, e);
  EXPECT_LT(e, high);
  EXPECT_LT(high - low, 0.1);
}

TEST_F(CalibrateMaterial, FitsTheForceOverTimeToo) {
  folder.write("material.toml", file_ + "observable = \"force-time\"\nprofiles = \"all\"\n");
  const Outcome outcome = rebound({"calibrate", "material.toml", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_NEAR(json["estimates"][0]["value"].get<double>(), 0.3, 0.01);
  EXPECT_NEAR(json["estimates"][1]["value"].get<double>(), 0.3e-3, 0.02e-3);
  const auto& profile = json["estimates"][0]["profile"];
  ASSERT_FALSE(profile.is_null()) << json["estimates"][0].dump();
  EXPECT_LT(profile["interval"][0].get<double>(), json["estimates"][0]["value"].get<double>());
  EXPECT_GT(profile["interval"][1].get<double>(), json["estimates"][0]["value"].get<double>());
}

TEST_F(CalibrateMaterial, AnUnknownNumberNamesThoseThereAre) {
  folder.write("material.toml", replaced(file_, "branch[0].ratio", "branch[3].ratio"));
  const Outcome outcome = rebound({"calibrate", "material.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("material.toml:5"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("branch[0].relaxation_time"), std::string::npos) << outcome.errors;
}

TEST_F(CalibrateMaterial, AnotherBallIsRefused) {
  folder.write("start.toml", replaced(fem_file, "89.6 g", "100 g"));
  const Outcome outcome = rebound({"calibrate", "material.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("100 g"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
