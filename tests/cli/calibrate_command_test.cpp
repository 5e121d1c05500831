// `calibrate` and `benchmark` on what `lumped --out` wrote.
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class CalibrateCommand : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("impact.toml", lumped_file);
    ASSERT_EQ(rebound({"lumped", "impact.toml", "--out", "reference"}).exit_code, 0);
  }
  nlohmann::json json_of(const Outcome& outcome) const {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  }
  const std::string references_ = "[[reference]]\nfolder = \"reference\"\n";
};

TEST_F(CalibrateCommand, RecoversTheParametersAndTheyRun) {
  folder.write("calibrate.toml", "schema = 1\nlaw = \"hunt-crossley\"\n" + references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json", "--out", "found"}));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_NEAR(json["estimates"][0]["value"].get<double>() / 3.5e6, 1.0, 1e-5);
  EXPECT_NEAR(json["estimates"][1]["value"].get<double>() / 17.63e4, 1.0, 1e-5);
  EXPECT_EQ(json["noise"], "estimated");
  EXPECT_EQ(json["estimates"][0]["identifiability"], "identified");
  const auto again = json_of(rebound({"lumped", "found/calibrated.toml", "--json"}));
  const auto before = json_of(rebound({"lumped", "impact.toml", "--json"}));
  EXPECT_NEAR(again["restitution"].get<double>(), before["restitution"].get<double>(), 1e-5);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "found" / "calibration.json"));
}

TEST_F(CalibrateCommand, UnidentifiableIsSaid) {
  folder.write("calibrate.toml",
               "schema = 1\nlaw = \"equivalent-kelvin-voigt\"\n" + references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json"}));
  EXPECT_EQ(json["estimates"][0]["identifiability"], "not-identifiable");
  EXPECT_TRUE(json["estimates"][0]["standard_error"].is_null());
}

TEST_F(CalibrateCommand, ProfilesAndNuisancesAreOnRequest) {
  folder.write("calibrate.toml",
               "schema = 1\nlaw = \"linear-kelvin-voigt\"\nprofiles = \"all\"\nloss = \"huber\"\n"
               "observable = \"force-time\"\n" + references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json", "--out", "found"}));
  EXPECT_EQ(json["estimates"][0]["profile"]["closed"][0], true);
  EXPECT_LT(json["estimates"][0]["profile"]["interval"][0].get<double>(),
            json["estimates"][0]["value"].get<double>());
  EXPECT_FALSE(there("found/checkpoint.json"));
  folder.write("nuisance.toml", "schema = 1\nlaw = \"linear-kelvin-voigt\"\n[nuisance]\ngain = 0.03\n" +
                                    references_);
  EXPECT_EQ(rebound({"calibrate", "nuisance.toml"}).exit_code, 2);  // noise unknown
}

TEST_F(CalibrateCommand, ADamagedCheckpointIsCorrupt) {
  folder.write("calibrate.toml", "schema = 1\nlaw = \"hunt-crossley\"\n" + references_);
  std::filesystem::create_directory(folder.path() / "found");
  folder.write("found/checkpoint.json", "{\"schema\": 1, \"sha");
  EXPECT_EQ(rebound({"calibrate", "calibrate.toml", "--out", "found"}).exit_code, 5);
}

TEST_F(CalibrateCommand, BenchmarkScoresLawsOnTheReference) {
  folder.write("benchmark.toml",
               "schema = 1\n[[law]]\nlabel = \"the same\"\nfile = \"impact.toml\"\n"
               "[[law]]\nlabel = \"spring and dashpot\"\nlaw = \"linear-kelvin-voigt\"\n" +
                   references_);
  const auto json = json_of(rebound({"benchmark", "benchmark.toml", "--json"}));
  EXPECT_EQ(json["laws"].size(), 2u);
  EXPECT_NEAR(json["cells"][0][0]["against_reference"]["restitution"].get<double>(), 0.0, 1e-6);
  EXPECT_GT(json["cells"][1][0]["force_deflection_rms"].get<double>(), 0.02);
  const auto text = rebound({"benchmark", "benchmark.toml"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.output.find("spring and dashpot"), std::string::npos);
}

TEST_F(CalibrateCommand, SelectRanksLaws) {
  folder.write("select.toml",
               "schema = 1\n[[law]]\nlabel = \"Hunt-Crossley\"\nlaw = \"hunt-crossley\"\n"
               "[[law]]\nlabel = \"spring and dashpot\"\nlaw = \"linear-kelvin-voigt\"\n" +
                   references_);
  const auto json = json_of(rebound({"select", "select.toml", "--json", "--out", "chosen"}));
  EXPECT_EQ(json["chosen"], nlohmann::json::array({"Hunt-Crossley"}));
  EXPECT_TRUE(there("chosen/selection.json"));
  folder.write("one.toml", "schema = 1\n[[law]]\nlabel = \"a\"\nlaw = \"tsuji\"\n" + references_);
  EXPECT_EQ(rebound({"select", "one.toml"}).exit_code, 2);
}

TEST_F(CalibrateCommand, BadInputNamesTheKey) {
  const std::string file = "schema = 1\nlaw = \"hunt-crossley\"\n" + references_;
  const std::pair<std::string, int> cases[] = {
      {replaced(file, "hunt-crossley", "hunt-crosley"), 2},
      {replaced(file, "folder", "folders"), 2},
      {replaced(file, "\"reference\"", "\"nowhere\""), 4},
      {replaced(file, "law =", "damping_formula = \"exact\"\nfree = [\"exponent\"]\nlaw ="), 2},
      {replaced(file, "law =", "free = [\"colour\"]\nlaw ="), 2},
      {"schema = 1\nlaw = \"hunt-crossley\"\n", 2},
  };
  for (const auto& [text, code] : cases) {
    folder.write("calibrate.toml", text);
    const Outcome outcome = rebound({"calibrate", "calibrate.toml", "--json"});
    EXPECT_EQ(outcome.exit_code, code) << text;
    const auto error = nlohmann::json::parse(outcome.output)["error"];
    EXPECT_FALSE(error["key"].is_null()) << text;
  }
}

}  // namespace
}  // namespace rebound::testing
