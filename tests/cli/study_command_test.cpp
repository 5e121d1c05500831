#include <map>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

/// A ball with a loss that the material of the study can follow.
const std::string dataset_file = R"(schema = 1
name = "test ball"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[[shot]]
speed = "5 m/s"
restitution = 0.75
restitution_uncertainty = 0.02
contact_time = "2.3 ms"
contact_time_uncertainty = "0.1 ms"
mean_deflection = "2.4 mm"
[[shot]]
speed = "15 m/s"
restitution = 0.72
restitution_uncertainty = 0.02
contact_time = "1.9 ms"
contact_time_uncertainty = "0.1 ms"
[[quasistatic]]
platens = 2
stiffness = "4.053e5 N/m^1.5"
)";

const std::string published_file = R"(schema = 1
name = "test ball"
source = "made for this test"
poisson_ratio = 0.4
hertz_stiffness = "2.81e5 N/m^1.5"
hunt_crossley_stiffness = "3.50e6 N/m^1.5"
[[at_speed]]
speed = "5 m/s"
hunt_crossley_damping = "20.0e4 N.s/m^2.5"
linear_damping = "31.95 N.s/m"
linear_stiffness = "1.54e5 N/m"
damping_factor = 0.136
linear_contact_time = "2.42 ms"
linear_restitution = 0.649
[[at_speed]]
speed = "15 m/s"
hunt_crossley_damping = "9.0e4 N.s/m^2.5"
linear_damping = "44.05 N.s/m"
linear_stiffness = "2.20e5 N/m"
damping_factor = 0.156
linear_contact_time = "2.03 ms"
linear_restitution = 0.607
)";

const std::string study_file = R"(schema = 1
title = "A study of </script> one ball"
[fem]
poisson_ratio = 0.4
cells = 200
coarse_cells = 120
calibration_cells = 80
[[fem.branch]]
ratio = 1.0
relaxation_time = "0.2 ms"
fit_time = false
[[core]]
label = "T"
data = "ball"
)";

/// The matrices of a page by their titles, as its figures read them.
std::map<std::string, nlohmann::json> matrices_of(const std::string& page) {
  const std::string opening = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(opening) + opening.size();
  const auto data =
      nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  std::map<std::string, nlohmann::json> matrices;
  for (const auto& section : data["sections"])
    for (const auto& block : section["blocks"])
      if (block["kind"] == "matrix") matrices[block["title"]] = block;
  return matrices;
}

class StudyCommandTest : public ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder.path() / "ball");
    folder.write("ball/dataset.toml", dataset_file);
    folder.write("ball/published_model_values.toml", published_file);
    folder.write("study.toml", study_file);
  }
};

TEST_F(StudyCommandTest, GoesFromDataToReport) {
  const Outcome outcome = rebound({"study", "study.toml", "--json", "--out", "results"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  const auto& core = json["cores"].at(0);
  EXPECT_EQ(core["shots"].size(), 2u);
  for (const auto& shot : core["shots"]) {
    EXPECT_LE(shot["fem"]["impulse_closure"].get<double>(), 1e-6);
    EXPECT_LE(shot["fem"]["energy_closure"].get<double>(), 1e-3);
    // The fit has one unknown for the loss: restitution must be met.
    EXPECT_NEAR(shot["fem"]["restitution"].get<double>(),
                shot["measured"]["restitution"].get<double>(), 0.06);
    EXPECT_GT(shot["fem"]["cells"], shot["fem_coarse"]["cells"]);
  }
  for (const auto& law : core["laws"]) EXPECT_EQ(law["scores"].size(), 2u) << law["label"];
  const std::string page = read_whole(folder.path() / "results/report.html");
  const auto matrices = matrices_of(page);
  for (std::size_t law = 0; law < core["laws"].size(); ++law) {
    const auto& score = core["laws"][law]["scores"][0];
    const auto& shown = matrices.at("Force history against FE")["rows"][law]["cells"][0];
    EXPECT_DOUBLE_EQ(shown["value"].get<double>(),
                     100.0 * score["force_time_rms_of_peak"].get<double>());
  }
  EXPECT_NE(page.find("test ball"), std::string::npos);
  EXPECT_EQ(page.find("A study of </script>"), std::string::npos);
  EXPECT_EQ(page.find("Unfinished"), std::string::npos);
  // Where the first part can be read while the rest runs.
  EXPECT_NE(outcome.errors.find("the report so far, which grows: results/report.html"),
            std::string::npos)
      << outcome.errors;
  EXPECT_TRUE(there("results/study.json"));
}

TEST_F(StudyCommandTest, AReferenceCanBeRunAgainFromItsFolder) {
  ASSERT_EQ(rebound({"study", "study.toml", "--out", "results"}).exit_code, 0);
  const Outcome again = rebound({"fem", "results/core-T/fem-5mps/effective.toml", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  const auto stored =
      nlohmann::json::parse(read_whole(folder.path() / "results/core-T/fem-5mps/result.json"));
  const auto repeated = nlohmann::json::parse(again.output);
  EXPECT_EQ(repeated["restitution"], stored["restitution"]);
  EXPECT_EQ(repeated["peak_force_N"], stored["peak_force_N"]);
}

TEST_F(StudyCommandTest, AnInterruptionSaysWhatIsKept) {
  folder.write("long.toml",
               replaced(study_file, "calibration_cells = 80", "calibration_cells = 20000"));
  const Outcome outcome = rebound({"study", "long.toml", "--out", "results"},
                                  {.arguments = {}, .folder = {}, .interrupt_after_ms = 6000});
  EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
  EXPECT_NE(outcome.errors.find("no core was complete"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("again"), std::string::npos) << outcome.errors;
}

TEST_F(StudyCommandTest, RefusesDataWithoutWhatTheChainNeeds) {
  folder.write("ball/dataset.toml",
               replaced(dataset_file, "restitution = 0.75\nrestitution_uncertainty = 0.02\n", ""));
  const Outcome outcome = rebound({"study", "study.toml", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("restitution and contact time"), std::string::npos)
      << outcome.errors;
  EXPECT_FALSE(there("results/report.html"));
}

TEST_F(StudyCommandTest, RefusesALabelThatLeavesTheFolder) {
  folder.write("bad.toml", replaced(study_file, "label = \"T\"", "label = \"../T\""));
  const Outcome outcome = rebound({"study", "bad.toml", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("core[0].label"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("bad.toml:13"), std::string::npos) << outcome.errors;
}

TEST_F(StudyCommandTest, RefusesAnUnknownKeyWithTheNearestKnownOne) {
  folder.write("bad.toml", replaced(study_file, "coarse_cells", "coarse_cell"));
  const Outcome outcome = rebound({"study", "bad.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("coarse_cells"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace rebound::testing
