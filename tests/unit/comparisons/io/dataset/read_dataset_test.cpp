#include "comparisons/io/dataset/read_dataset.hpp"

#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;
using testing::TemporaryFolder;

const std::string head = R"(schema = 1
name = "ball"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
mass_uncertainty = "0.4 g"
)";

Dataset read_with_head(const TemporaryFolder& folder, const std::string& rest) {
  folder.write("dataset.toml", head + rest);
  return read_dataset(folder.path());
}

TEST(ReadDatasetTest, ReadsTheContractsExample) {
  const TemporaryFolder folder;
  folder.write("shot-05.csv", "time_s,force_N\n0,0\n0.001,700\n0.002,0\n");
  folder.write("compression.csv", "deflection_m,force_N\n0,0\n0.001,10\n0.0005,4\n");
  const Dataset dataset = read_with_head(folder, R"([instrument]
force_noise = "10 N"
force_gain_uncertainty = 0.03
force_bandwidth = "20 kHz"
contact_threshold = "10 N"
camera_rate = "4000 Hz"
deflection = "integrated"
[[shot]]
speed = "5 m/s"
speed_uncertainty = "0.05 m/s"
trace = "shot-05.csv"
restitution = 0.606
restitution_uncertainty = 0.01
[[shot]]
speed = "15 m/s"
contact_time = "1.91 ms"
contact_time_uncertainty = "0.06 ms"
[[quasistatic]]
trace = "compression.csv"
platens = 2
)");
  EXPECT_EQ(dataset.mass_uncertainty, 0.4e-3);
  EXPECT_EQ(dataset.instrument.force_bandwidth, 20e3);
  EXPECT_EQ(dataset.instrument.deflection, DeflectionOrigin::integrated);
  ASSERT_EQ(dataset.shots.size(), 2u);
  ASSERT_TRUE(dataset.shots[0].has_history());
  EXPECT_EQ(dataset.shots[0].trace.force[1], 700.0);
  EXPECT_TRUE(dataset.shots[0].trace.deflection.empty());
  EXPECT_EQ(dataset.shots[0].restitution.value, 0.606);
  EXPECT_FALSE(dataset.shots[1].has_history());
  EXPECT_EQ(dataset.shots[1].contact_time.uncertainty, 0.06e-3);
  ASSERT_EQ(dataset.quasistatic.size(), 1u);
  EXPECT_EQ(dataset.quasistatic[0].platens, 2);
  EXPECT_EQ(dataset.quasistatic[0].curve->force[2], 4.0);
}

TEST(ReadDatasetTest, WritingGivesTheSameDatasetBack) {
  const TemporaryFolder folder;
  const Dataset dataset = read_with_head(folder, R"([[shot]]
speed = "5 m/s"
peak_force = "750 N"
mean_deflection = "1.93 mm"
[[quasistatic]]
stiffness = "4.053e5 N/m^1.5"
platens = 2
[[block]]
modulus = "1.94 MPa"
[[pooled_peak]]
speed = "5 m/s"
force = "750 N"
deflection = "3 mm"
)");
  const std::string text = write_toml(dataset);
  folder.write("dataset.toml", text);
  EXPECT_EQ(write_toml(read_dataset(folder.path())), text);
}

TEST(ReadDatasetTest, TellsOfALeftOutLine) {
  const TemporaryFolder folder;
  folder.write("a.csv", "time_s,force_N\n0,0\n1,2\n2,3\n3,5");
  const Dataset dataset =
      read_with_head(folder, "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"a.csv\"\n");
  EXPECT_EQ(dataset.shots[0].trace.time.size(), 3u);
  ASSERT_EQ(dataset.notes.size(), 1u);
  EXPECT_NE(dataset.notes[0].find("line 5"), std::string::npos);
}

TEST(ReadDatasetTest, TracesMayNotLeaveTheFolder) {
  const TemporaryFolder outside;
  const auto target = outside.write("a.csv", "time_s,force_N\n0,0\n1,2\n2,3\n");
  const TemporaryFolder folder;
  std::filesystem::create_symlink(target, folder.path() / "link.csv");
  for (const std::string& path :
       {target.string(), std::string("../a.csv"), std::string("link.csv")}) {
    const Error error = refusal_of(
        [&] { read_with_head(folder, "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"" + path + "\"\n"); });
    EXPECT_EQ(error.location().key, "shot[0].trace") << path;
    EXPECT_EQ(error.location().line, 9) << path;
    EXPECT_NE(std::string(error.what()).find("outside"), std::string::npos) << error.what();
  }
}

// What `synthesize` leaves is a folder with the data set beside the truth.
TEST(ReadDatasetTest, NamesTheFolderWithinThatHoldsOne) {
  const TemporaryFolder folder;
  const auto refusal = [&] { return refusal_of([&] { read_dataset(folder.path()); }); };
  EXPECT_NE(std::string(refusal().what()).find("rebound init dataset"), std::string::npos);
  const std::filesystem::path within = folder.path() / "data";
  std::filesystem::create_directory(within);
  folder.write("data/dataset.toml", head);
  EXPECT_EQ(refusal().code(), ExitCode::input_output_failed);
  EXPECT_NE(std::string(refusal().what()).find("did you mean " + within.string() + "?"),
            std::string::npos)
      << refusal().what();
}

struct RefusedDataset {
  const char* name;
  const char* text;
  ExitCode code;
  const char* key;
};

class ReadDatasetRefuses : public ::testing::TestWithParam<RefusedDataset> {};

TEST_P(ReadDatasetRefuses, WithItsKey) {
  const TemporaryFolder folder;
  folder.write("two.csv", "time_s,force_N\n0,0\n1,2\n");
  const Error error = refusal_of([&] { read_with_head(folder, GetParam().text); });
  EXPECT_EQ(error.code(), GetParam().code);
  EXPECT_EQ(error.location().key, GetParam().key);
  EXPECT_FALSE(error.location().file.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ReadDatasetRefuses,
    ::testing::Values(
        RefusedDataset{"NothingInAShot", "[[shot]]\nspeed = \"5 m/s\"\n", ExitCode::bad_input,
                       "shot[0]"},
        RefusedDataset{"UncertaintyAlone",
                       "[[shot]]\nspeed = \"5 m/s\"\ncontact_time = \"1 ms\"\n"
                       "restitution_uncertainty = 0.1\n",
                       ExitCode::bad_input, "shot[0].restitution_uncertainty"},
        RefusedDataset{"Restitution", "[[shot]]\nspeed = \"5 m/s\"\nrestitution = 1.5\n",
                       ExitCode::bad_input, "shot[0].restitution"},
        RefusedDataset{"Speed", "[[shot]]\nspeed = \"-5 m/s\"\nrestitution = 0.5\n",
                       ExitCode::bad_input, "shot[0].speed"},
        RefusedDataset{
            "ErrorBeyondAnyInstrument",
            "[[shot]]\nspeed = \"5 m/s\"\nspeed_uncertainty = \"1e308 m/s\"\nrestitution = 0.5\n",
            ExitCode::bad_input, "shot[0].speed_uncertainty"},
        RefusedDataset{"NoFile", "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"none.csv\"\n",
                       ExitCode::input_output_failed, "shot[0].trace"},
        RefusedDataset{"TwoSamples", "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"two.csv\"\n",
                       ExitCode::bad_input, ""},
        RefusedDataset{"Platens", "[[quasistatic]]\nplatens = 3\nstiffness = \"1 N/m^1.5\"\n",
                       ExitCode::bad_input, "quasistatic[0].platens"},
        RefusedDataset{"NothingInATest", "[[quasistatic]]\nplatens = 2\n", ExitCode::bad_input,
                       "quasistatic[0]"},
        RefusedDataset{
            "NoSuchScalar",
            "[instrument]\nindependent_scalars = [\"peak\"]\n[[shot]]\nspeed = \"5 m/s\"\n"
            "restitution = 0.5\n",
            ExitCode::bad_input, "instrument.independent_scalars"},
        RefusedDataset{"DeflectionNoise",
                       "[instrument]\ndeflection_noise = \"0 mm\"\n[[shot]]\nspeed = \"5 m/s\"\n"
                       "restitution = 0.5\n",
                       ExitCode::bad_input, "instrument.deflection_noise"},
        RefusedDataset{
            "Duration",
            "[[quasistatic]]\nplatens = 2\nstiffness = \"1 N/m^1.5\"\nduration = \"0 s\"\n",
            ExitCode::bad_input, "quasistatic[0].duration"},
        RefusedDataset{"Typo", "[[shots]]\nspeed = \"5 m/s\"\n", ExitCode::bad_input, "shots"}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rebound
