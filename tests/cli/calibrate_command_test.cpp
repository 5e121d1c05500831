// `calibrate` and `benchmark` on what `lumped --out` wrote.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

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
  folder.write("calibrate.toml", "schema = 1\nlaw = \"equivalent-kelvin-voigt\"\n" + references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json"}));
  EXPECT_EQ(json["estimates"][0]["identifiability"], "not-identifiable");
  EXPECT_TRUE(json["estimates"][0]["standard_error"].is_null());
}

TEST_F(CalibrateCommand, ProfilesAndNuisancesAreOnRequest) {
  folder.write("calibrate.toml",
               "schema = 1\nlaw = \"linear-kelvin-voigt\"\nprofiles = \"all\"\nloss = \"huber\"\n"
               "observable = \"force-time\"\n" +
                   references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json", "--out", "found"}));
  EXPECT_EQ(json["estimates"][0]["profile"]["closed"][0], true);
  EXPECT_LT(json["estimates"][0]["profile"]["interval"][0].get<double>(),
            json["estimates"][0]["value"].get<double>());
  EXPECT_FALSE(there("found/checkpoint.json"));
  folder.write(
      "nuisance.toml",
      "schema = 1\nlaw = \"linear-kelvin-voigt\"\n[nuisance]\ngain = 0.03\n" + references_);
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

/// The reference's trace, line by line, with its header.
class BadData : public CalibrateCommand {
 protected:
  std::vector<std::string> lines() const {
    std::ifstream file(folder.path() / "reference" / "trace.csv");
    std::vector<std::string> all;
    for (std::string line; std::getline(file, line);) all.push_back(line);
    return all;
  }
  void expect_refused(const std::vector<std::string>& trace, const std::string& what,
                      const std::string& keys = "law = \"hunt-crossley\"\n") const {
    std::string text;
    for (const auto& line : trace) text += line + "\n";
    folder.write("reference/trace.csv", text);
    folder.write("calibrate.toml", "schema = 1\n" + keys + references_);
    const Outcome outcome = rebound({"calibrate", "calibrate.toml"});
    EXPECT_EQ(outcome.exit_code, 2) << what;
    EXPECT_NE(outcome.errors.find(what), std::string::npos) << outcome.errors;
  }
};

TEST_F(BadData, AFlatForceIsRefused) {
  auto trace = lines();
  for (std::size_t i = 1; i < trace.size(); ++i)
    trace[i] = trace[i].substr(0, trace[i].find(',')) + ",100,0.001";
  expect_refused(trace, "flat");
}

TEST_F(BadData, TwoPointsAreTooFew) {
  auto trace = lines();
  trace.resize(3);
  expect_refused(trace, "five instants");
}

TEST_F(BadData, MoreParametersThanDataAreRefused) {
  std::vector<std::string> trace = {lines().front()};
  for (std::size_t i = 1; i < lines().size(); i += 80) trace.push_back(lines()[i]);
  expect_refused(trace, "fewer data than parameters", "law = \"power-law\"\ntip_margin = 0.5\n");
}

TEST_F(BadData, TimeThatGoesBackwardsIsRefusedWithItsLine) {
  auto trace = lines();
  trace[50] = trace[20];
  expect_refused(trace, "trace.csv:51");
}

TEST_F(BadData, ARestitutionAboveOneIsRefused) {
  std::filesystem::create_directory(folder.path() / "data");
  std::filesystem::copy_file(folder.path() / "reference" / "trace.csv",
                             folder.path() / "data" / "shot.csv");
  folder.write("data/dataset.toml",
               "schema = 1\nname = \"data\"\n[sphere]\nmass = \"89.6 g\"\n"
               "diameter = \"66.2 mm\"\n[[shot]]\nspeed = \"15 m/s\"\ntrace = \"shot.csv\"\n"
               "restitution = 1.02\n");
  folder.write("calibrate.toml",
               "schema = 1\nlaw = \"hunt-crossley\"\ndamping_formula = \"exact\"\n"
               "[[reference]]\nfolder = \"data\"\n");
  const Outcome outcome = rebound({"calibrate", "calibrate.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("1.02"), std::string::npos) << outcome.errors;
}

// Data of an overdamped spring and dashpot, fitted under a rule by which it never comes back.
TEST_F(BadData, OverdampedUnderZeroDeflectionIsNotIdentifiable) {
  std::string spring = replaced(lumped_file, "hunt-crossley", "linear-kelvin-voigt");
  spring =
      replaced(replaced(spring, "3.5e6 N/m^1.5", "2.5e5 N/m"), "17.63e4 N.s/m^2.5", "900 N.s/m");
  folder.write("spring.toml", spring);
  ASSERT_EQ(rebound({"lumped", "spring.toml", "--out", "reference"}).exit_code, 0);
  const std::string rule = "[impact]\nseparation = \"zero-deflection\"\n";
  folder.write("overdamped.toml", replaced(spring, "[impact]\n", rule));
  const Outcome alone = rebound({"lumped", "overdamped.toml"});
  EXPECT_EQ(alone.exit_code, 3);
  EXPECT_NE(alone.errors.find("overdamped"), std::string::npos) << alone.errors;
  const auto stored = folder.path() / "reference";
  for (const char* name : {"effective.toml", "result.json"}) {
    std::ostringstream text;
    text << std::ifstream(stored / name).rdbuf();
    folder.write(std::string("reference/") + name,
                 replaced(text.str(), "zero-force", "zero-deflection"));
  }
  folder.write("calibrate.toml", "schema = 1\nlaw = \"linear-kelvin-voigt\"\n" + references_);
  const auto json = json_of(rebound({"calibrate", "calibrate.toml", "--json"}));
  for (const auto& estimate : json["estimates"])
    EXPECT_EQ(estimate["identifiability"], "not-identifiable");
}

}  // namespace
}  // namespace rebound::testing
