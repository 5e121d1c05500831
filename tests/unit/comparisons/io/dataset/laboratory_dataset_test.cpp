#include <fmt/format.h>
#include <cmath>
#include <numbers>

#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;
using testing::TemporaryFolder;

const std::string laboratory_head = R"(schema = 1
name = "ball"
[sphere]
mass = "100 g"
diameter = "60 mm"
)";

Dataset read_laboratory(const TemporaryFolder& folder, const std::string& rest) {
  folder.write("dataset.toml", laboratory_head + rest);
  return read_dataset(folder.path());
}

/// A half sine of 200 g on an offset of 5 g that drifts by 1 g a second, recorded as negative, with
/// decimal commas; 2 ms of contact in 60 ms.
std::string accelerometer_file() {
  std::string text = "Zeit;a1\n(ms);(g)\n";
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 2e-5, in = t - 0.02;
    const double a = in > 0.0 && in < 2e-3 ? 200.0 * std::sin(std::numbers::pi * in / 2e-3) : 0.0;
    std::string line = fmt::format("{:.2f};{:.6f}\n", 1e3 * t, -(a + 5.0 + t));
    for (char& sign : line)
      if (sign == '.') sign = ',';
    text += line;
  }
  return text;
}

TEST(TraceChannelsTest, ForceFromAccelerationWithItsBaselineOutAndCut) {
  const TemporaryFolder folder;
  folder.write("a.csv", accelerometer_file());
  const std::string shot = "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"a.csv\"\n";
  const Dataset dataset = read_laboratory(folder, R"([channels]
time = "Zeit"
acceleration = "a1"
reversed = true
baseline = "before-and-after"
keep = "around-contact"
)" + shot);
  const Trace& trace = dataset.shots[0].trace;
  const double peak = *std::max_element(trace.force.begin(), trace.force.end());
  EXPECT_NEAR(peak, 0.1 * 200.0 * 9.80665, 1e-3);
  EXPECT_NEAR(trace.force.front(), 0.0, 1e-3);
  EXPECT_NEAR(trace.force.back(), 0.0, 1e-3);
  EXPECT_NEAR(trace.time.back() - trace.time.front(), 8 * 1.87e-3, 0.2e-3);
  const Error wrong_sign = refusal_of([&] {
    read_laboratory(folder, "[channels]\ntime = \"Zeit\"\nacceleration = \"a1\"\n" + shot);
  });
  EXPECT_EQ(wrong_sign.location().key, "channels.reversed");
  const Error wrong_unit = refusal_of([&] {
    read_laboratory(folder,
                    "[channels]\ntime = \"Zeit\"\nforce = \"a1\"\nreversed = true\n" + shot);
  });
  EXPECT_NE(wrong_unit.location().file.find("a.csv"), std::string::npos);
  EXPECT_EQ(wrong_unit.location().key, "a1");
}

TEST(TraceChannelsTest, ABaselineNeedsSomethingBeforeContact) {
  const TemporaryFolder folder;
  folder.write("a.csv", "time_ms,force_kN\n0,0\n1,2\n2,3\n3,1\n");
  const std::string shot = "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"a.csv\"\n";
  EXPECT_DOUBLE_EQ(read_laboratory(folder, shot).shots[0].trace.force[2], 3000.0);
  const Error error = refusal_of(
      [&] { read_laboratory(folder, "[channels]\nbaseline = \"before-contact\"\n" + shot); });
  EXPECT_EQ(error.location().key, "channels.baseline");
  EXPECT_NE(error.location().file.find("a.csv"), std::string::npos);
}

/// Whether such a record is used is for others to say; its sign is right.
TEST(TraceChannelsTest, ARecordThatStartsOrEndsInContactIsNotReversed) {
  const TemporaryFolder folder;
  const std::string shot = "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"a.csv\"\n";
  for (const char* rows : {"0,90\n1,100\n2,50\n3,0\n4,0\n", "0,0\n1,0\n2,60\n3,100\n4,90\n"}) {
    folder.write("a.csv", std::string("time_ms,force_N\n") + rows);
    EXPECT_EQ(read_laboratory(folder, shot).shots[0].trace.force.size(), 5u);
  }
}

TEST(ShotReadingsTest, SpeedAndRestitutionFromGatesHeightsAndTimes) {
  const TemporaryFolder folder;
  const Dataset dataset = read_laboratory(folder, R"(
[[shot]]
gate_distance = "100 mm"
gate_time = "20 ms"
gate_time_uncertainty = "0.2 ms"
rebound_gate_time = "40 ms"
rebound_gate_time_uncertainty = "0.4 ms"
[[shot]]
drop_height = "1 m"
rebound_height = "0.25 m"
rebound_height_uncertainty = "10 mm"
repeats = 4
[[shot]]
flight_time = "0.8 s"
next_flight_time = "0.6 s"
)");
  EXPECT_DOUBLE_EQ(dataset.shots[0].impact.speed, 5.0);
  EXPECT_NEAR(*dataset.shots[0].restitution.value, 0.5, 1e-12);
  EXPECT_NEAR(*dataset.shots[0].restitution.uncertainty, 0.5 * 0.01 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(*dataset.shots[0].speed_uncertainty, 0.05, 1e-6);
  EXPECT_NEAR(*dataset.shots[1].restitution.value, 0.5, 1e-12);
  // e = sqrt(h2/h1): half of 4 %, four readings
  EXPECT_NEAR(*dataset.shots[1].restitution.uncertainty, 0.5 * 0.02 / 2.0, 1e-6);
  EXPECT_NEAR(*dataset.shots[2].restitution.value, 0.75, 1e-12);
  ASSERT_EQ(dataset.notes.size(), 1u);
  EXPECT_NE(dataset.notes[0].find("not taken out"), std::string::npos);
  folder.write("dataset.toml", write_toml(dataset));
  const Dataset again = read_dataset(folder.path());
  EXPECT_EQ(again.shots[2].impact.speed, dataset.shots[2].impact.speed);
  EXPECT_EQ(again.shots[1].restitution.uncertainty, dataset.shots[1].restitution.uncertainty);
}

// The distance of the gates cancels in their ratio: what differences leave of it is rounding, and a
// fit that weighed by it would see this shot alone.
TEST(ShotReadingsTest, AnUncertaintyThatCancelsIsNone) {
  const TemporaryFolder folder;
  const Dataset dataset = read_laboratory(folder, R"(
[[shot]]
gate_distance = "200 mm"
gate_distance_uncertainty = "0.5 mm"
gate_time = "20 ms"
rebound_gate_time = "27 ms"
)");
  EXPECT_NEAR(*dataset.shots[0].restitution.value, 20.0 / 27.0, 1e-12);
  EXPECT_FALSE(dataset.shots[0].restitution.uncertainty.has_value());
  EXPECT_NEAR(*dataset.shots[0].speed_uncertainty, 10.0 * 0.5 / 200.0, 1e-9);
}

TEST(ShotReadingsTest, AirRaisesTheRestitutionOfADrop) {
  const TemporaryFolder folder;
  const std::string shot = "[[shot]]\ndrop_height = \"2 m\"\nrebound_height = \"1 m\"\n";
  const Dataset without = read_laboratory(folder, shot);
  const Dataset with =
      read_laboratory(folder, "[air]\ndrag = \"corrected\"\ndrag_coefficient = 0.5\n" + shot);
  EXPECT_GT(*with.shots[0].restitution.value, *without.shots[0].restitution.value);
  EXPECT_LT(with.shots[0].impact.speed, without.shots[0].impact.speed);
  EXPECT_NE(with.notes[0].find("is taken out"), std::string::npos);
}

TEST(ShotTableTest, ReadsAShotARowOfOneBall) {
  const TemporaryFolder folder;
  folder.write("t.csv", "ball,in_mph,out_mph\n1,20,10\n2,30,12\n1,40,18\n");
  const std::string table = R"([[shot_table]]
file = "t.csv"
only_column = "ball"
only = "1"
restitution_relative_uncertainty = 0.04
[shot_table.columns]
speed = "in_mph"
rebound_speed = "out_mph"
)";
  const Dataset dataset = read_laboratory(folder, table);
  ASSERT_EQ(dataset.shots.size(), 2u);
  EXPECT_DOUBLE_EQ(dataset.shots[1].impact.speed, 40 * 0.44704);
  EXPECT_NEAR(*dataset.shots[1].restitution.value, 0.45, 1e-12);
  EXPECT_NEAR(*dataset.shots[1].restitution.uncertainty, 0.018, 1e-12);
  folder.write("t.csv", "ball,in_mph,out_mph\n1,20,10\n1,30,32\n");
  const Error faster = refusal_of([&] { read_laboratory(folder, table); });
  EXPECT_NE(faster.location().file.find("t.csv"), std::string::npos);
  EXPECT_EQ(faster.location().line, 3);
  folder.write("t.csv", "ball,in_mph,out_mph\n1,-20,10\n");
  EXPECT_EQ(refusal_of([&] { read_laboratory(folder, table); }).location().key, "in_mph");
  folder.write("t.csv", "ball,in_mph,out_mph\n7,20,10\n");
  EXPECT_EQ(refusal_of([&] { read_laboratory(folder, table); }).location().key,
            "shot_table[0].only");
}

struct RefusedReading {
  const char* name;
  const char* text;
  const char* key;
};

class ReadingsRefused : public ::testing::TestWithParam<RefusedReading> {};

TEST_P(ReadingsRefused, WithTheKey) {
  const TemporaryFolder folder;
  const Error error = refusal_of([&] { read_laboratory(folder, GetParam().text); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().key, GetParam().key);
  EXPECT_GT(error.location().line, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ReadingsRefused,
    ::testing::Values(
        RefusedReading{"NoSpeed", "[[shot]]\nrestitution = 0.5\n", "shot[0].speed"},
        RefusedReading{"ReboundAlone", "[[shot]]\nrebound_height = \"1 m\"\n", "shot[0].speed"},
        RefusedReading{"FasterThanItCame",
                       "[[shot]]\ndrop_height = \"1 m\"\nrebound_height = \"2 m\"\n",
                       "shot[0].restitution"},
        RefusedReading{"SpeedAgainstDrop", "[[shot]]\nspeed = \"9 m/s\"\ndrop_height = \"1 m\"\n",
                       "shot[0].speed"},
        RefusedReading{"UncertaintyAlone",
                       "[[shot]]\nspeed = \"9 m/s\"\nrestitution = 0.5\n"
                       "drop_height_uncertainty = \"1 mm\"\n",
                       "shot[0].drop_height_uncertainty"},
        RefusedReading{
            "ForceAndAcceleration",
            "[channels]\nforce = \"F\"\nacceleration = \"a\"\n[[shot]]\nspeed = \"9 m/s\"\n"
            "restitution = 0.5\n",
            "channels.acceleration"}),
    [](const auto& c) { return std::string(c.param.name); });

}  // namespace
}  // namespace rebound
