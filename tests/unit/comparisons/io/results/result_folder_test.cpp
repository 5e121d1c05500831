#include "comparisons/io/results/result_folder.hpp"

#include "comparisons/io/results/trace_csv.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::read_whole;
using testing::TemporaryFolder;

Trace small_trace() {
  return {.time = {0.0, 0.1, 0.2},
          .force = {0.0, 1.0 / 3.0, 0.0},
          .deflection = {0.0, 2.0 / 3.0, 0.1},
          .further = {}};
}

FemResult small_fem_result() {
  FemResult result;
  result.trace = small_trace();
  result.trace.further = {{"pole_deflection_m", {0.0, 1.0, 0.0}}};
  result.energies = {{.kinetic_centre_of_mass = 1.0}, {.stored = 0.5}, {.held = 0.25}};
  result.scalars.restitution = 0.5;
  return result;
}

ResultFolder target_in(const TemporaryFolder& folder) {
  return {.folder = folder.path() / "out", .effective_toml = "schema = 1\n", .provenance = {}};
}

TEST(TraceCsvTest, SeventeenDigitsReadBackToTheSameBits) {
  const std::string text = trace_csv(small_trace());
  EXPECT_TRUE(text.starts_with("time_s,force_N,deflection_m\n0,0,0\n"));
  const auto row = text.find("0.10000000000000001,0.33333333333333331,0.66666666666666663\n");
  EXPECT_NE(row, std::string::npos) << text;
}

TEST(TraceCsvTest, EnergiesFollowTheFurtherColumns) {
  const FemResult result = small_fem_result();
  const std::string text = trace_csv(result.trace, result.energies);
  EXPECT_TRUE(
      text.starts_with("time_s,force_N,deflection_m,pole_deflection_m,"
                       "kinetic_centre_of_mass_J,kinetic_vibration_J,stored_J,held_J,dissipated_J,"
                       "contact_constraint_J\n0,0,0,0,1,0,0,0,0,0\n"))
      << text;
  EXPECT_THROW(trace_csv(result.trace, {}), Error);
}

TEST(ResultFolderTest, ACompleteResultHasItsThreeFiles) {
  const TemporaryFolder folder;
  LumpedResult result;
  result.trace = small_trace();
  result.scalars.restitution = 0.5;
  write_result(target_in(folder), result);
  const Json json = Json::parse(read_whole(folder.path() / "out/result.json"));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["restitution"], 0.5);
  EXPECT_TRUE(json.contains("provenance"));
  EXPECT_EQ(read_whole(folder.path() / "out/effective.toml"), "schema = 1\n");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/trace.csv"));
}

TEST(ResultFolderTest, AnIncompleteRunReportsNoScalarAndReplacesAnEarlierResult) {
  const TemporaryFolder folder;
  FemResult result = small_fem_result();
  write_result(target_in(folder), result);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/result.json"));
  result.incomplete_because = "the contact did not end";
  write_result(target_in(folder), result);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/result.json"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/trace.csv"));
  const Json json = Json::parse(read_whole(folder.path() / "out/incomplete.json"));
  EXPECT_EQ(json["incomplete_because"], "the contact did not end");
  EXPECT_FALSE(json.contains("restitution"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/trace-incomplete.csv"));
  EXPECT_THROW(to_json(result), Error);
}

TEST(ErrorJsonTest, AbsentFieldsAreNull) {
  const Json json = to_json(Error(ExitCode::bad_input, "no", {.file = "f", .line = 3}));
  EXPECT_EQ(json["error"]["code"], 2);
  EXPECT_EQ(json["error"]["line"], 3);
  EXPECT_TRUE(json["error"]["key"].is_null());
  EXPECT_TRUE(json["error"]["allowed"].is_null());
}

}  // namespace
}  // namespace rebound
