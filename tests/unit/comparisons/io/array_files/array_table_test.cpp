#include "comparisons/io/laboratory/array_table.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "lumped/problem/dimension.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/write_arrays.hpp"

namespace rebound {
namespace {

using ::testing::ElementsAre;
using testing::ElementType;
using ::testing::HasSubstr;
using testing::MatlabVersion;
using testing::refusal_of;
using testing::TemporaryFolder;
using testing::WrittenArray;

const std::vector<double> times{0.1, 0.2, 0.4}, forces{1.5, -2.0, 3.25};

const std::vector<WantedColumn> time_and_force{
    {.heading = "time", .accepted = {dimension::time}, .increases = true},
    {.heading = "force", .accepted = {dimension::force}}};

class ArrayTableTest : public ::testing::Test {
 protected:
  std::filesystem::path path(const char* name) const { return folder.path() / name; }

  LaboratoryTable matlab(const std::vector<WrittenArray>& arrays,
                         MatlabVersion version = MatlabVersion::five) const {
    testing::write_matlab(path("a.mat"), arrays, version);
    return read_laboratory_table(path("a.mat"), time_and_force);
  }
  LaboratoryTable hdf5(const std::vector<WrittenArray>& arrays) const {
    testing::write_hdf5(path("a.h5"), arrays);
    return read_laboratory_table(path("a.h5"), time_and_force);
  }
  /// What the reader says of arrays, the same whatever the file.
  Error refused(const std::vector<WrittenArray>& arrays) const {
    const Error as_matlab = refusal_of([&] { matlab(arrays); });
    Error as_hdf5 = refusal_of([&] { hdf5(arrays); });
    EXPECT_STREQ(as_matlab.what(), as_hdf5.what());
    EXPECT_EQ(as_matlab.location().key, as_hdf5.location().key);
    EXPECT_EQ(as_matlab.location().file, path("a.mat").string());
    EXPECT_EQ(as_hdf5.location().file, path("a.h5").string());
    EXPECT_EQ(as_matlab.code(), ExitCode::bad_input);
    return as_hdf5;
  }

  TemporaryFolder folder;
};

void expect_the_record(const LaboratoryTable& table) {
  EXPECT_THAT(table.columns[0].numbers, ElementsAre(1e-3 * 0.1, 1e-3 * 0.2, 1e-3 * 0.4));
  EXPECT_THAT(table.columns[1].numbers, ElementsAre(1500.0, -2000.0, 3250.0));
  EXPECT_EQ(table.lines.size(), 3u);
}

TEST_F(ArrayTableTest, TheSameRecordAsTextAndAsArrays) {
  folder.write("a.csv", "time [ms],force [kN]\n0.1,1.5\n0.2,-2\n0.4,3.25\n");
  expect_the_record(read_laboratory_table(path("a.csv"), time_and_force));
  const std::vector<WrittenArray> named{{"time_ms", times}, {"force_kN", forces}};
  expect_the_record(matlab(named));
  expect_the_record(matlab(named, MatlabVersion::seven_three));
  expect_the_record(hdf5(named));
  expect_the_record(hdf5({{"time", times, "ms"}, {"force", forces, "kN"}}));
}

TEST_F(ArrayTableTest, StructuresGroupsTypesAndRowsAreRead) {
  std::vector<WantedColumn> wanted{
      {.heading = "run.time_ms", .accepted = {dimension::time}, .increases = true},
      {.heading = "run.force", .accepted = {dimension::force}}};
  for (const auto version : {MatlabVersion::five, MatlabVersion::seven_three}) {
    testing::write_matlab(path("s.mat"), {{"run.time_ms", times}, {"run.force_kN", forces}},
                          version);
    expect_the_record(read_laboratory_table(path("s.mat"), wanted));
  }
  wanted[0].heading = "run/time";
  wanted[1].heading = "run/force";
  testing::write_hdf5(path("s.h5"), {{"run/time", times, "ms"}, {"run/force_kN", forces}});
  expect_the_record(read_laboratory_table(path("s.h5"), wanted));
  // A row, whole numbers, single precision.
  const std::vector<WrittenArray> counts{
      {.name = "time_s", .values = {1, 2, 3}, .columns = 3, .type = ElementType::whole},
      {.name = "force_N", .values = {0.5, 2, 7}, .type = ElementType::single_precision}};
  const std::vector<WrittenArray> signed_counts{
      {"time_s", {1, 2, 3}},
      {.name = "force_N", .values = {-3, 0, 300}, .type = ElementType::whole}};
  EXPECT_THAT(matlab(signed_counts).columns[1].numbers, ElementsAre(-3, 0, 300));
  EXPECT_THAT(hdf5(signed_counts).columns[1].numbers, ElementsAre(-3, 0, 300));
  EXPECT_THAT(matlab(counts).columns[0].numbers, ElementsAre(1, 2, 3));
  EXPECT_THAT(matlab(counts, MatlabVersion::seven_three).columns[1].numbers,
              ElementsAre(0.5, 2, 7));
  EXPECT_THAT(hdf5(counts).columns[0].numbers, ElementsAre(1, 2, 3));
  EXPECT_THAT(hdf5(counts).columns[1].numbers, ElementsAre(0.5, 2, 7));
}

TEST_F(ArrayTableTest, AMissingVariableIsNamedWithThoseThatAreThere) {
  const Error error = refused({{"t_ms", times}, {"force_N", forces}});
  EXPECT_STREQ(error.what(), "the variable is missing");
  EXPECT_EQ(error.location().key, "time");
  EXPECT_THAT(error.location().value, HasSubstr("t_ms"));
}

TEST_F(ArrayTableTest, WhatIsNoVectorOfNumbersIsRefused) {
  const Error matrix =
      refused({{"time_s", times}, {.name = "force_N", .values = {1, 2, 3, 4, 5, 6}, .columns = 2}});
  EXPECT_STREQ(matrix.what(), "the variable is no vector");
  EXPECT_EQ(matrix.location().value, "3 x 2");
  const Error shorter = refused({{"time_s", times}, {"force_N", {1, 2}}});
  EXPECT_EQ(shorter.location().key, "force_N");
  EXPECT_EQ(shorter.location().allowed, "3 numbers, as time_s has");
  testing::write_matlab(path("o.mat"), {{"time_s", times}});
  testing::add_matlab_others(path("o.mat"));
  for (const auto& [name, kind] :
       {std::pair{"words", "text"}, {"waves", "complex numbers"}, {"parts", "a cell array"}}) {
    std::vector<WantedColumn> wanted = time_and_force;
    wanted[1].heading = name;
    const Error other = refusal_of([&] { read_laboratory_table(path("o.mat"), wanted); });
    EXPECT_EQ(other.location().key, name);
    EXPECT_EQ(other.location().value, kind);
  }
}

TEST_F(ArrayTableTest, NumbersThatAreNoneAndTimesThatGoBackAreNamedByTheirPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_STREQ(refused({{"time_s", times}, {"force_N", {1, nan, 3}}}).what(),
               "element 2 is not finite");
  EXPECT_STREQ(refused({{"time_s", times}, {"force_N", {1, 2, -infinite}}}).what(),
               "element 3 is not finite");
  const Error back = refused({{"time_ms", {0.1, 0.3, 0.2}}, {"force_N", forces}});
  EXPECT_STREQ(back.what(), "element 3 does not increase");
  EXPECT_EQ(back.location().key, "time_ms");
  EXPECT_STREQ(refused({{"time_ms", {0.1, 0.1, 0.2}}, {"force_N", forces}}).what(),
               "element 2 does not increase");
}

TEST_F(ArrayTableTest, AUnitIsStatedOrRefused) {
  const Error none = refused({{"time", times}, {"force_N", forces}});
  EXPECT_EQ(none.location().key, "time");
  EXPECT_THAT(none.what(), HasSubstr("states no unit"));
  EXPECT_THAT(none.location().allowed, HasSubstr("s"));
  EXPECT_THAT(refused({{"time_mm", times}, {"force_N", forces}}).what(), HasSubstr("another unit"));
  const Error unknown = refusal_of([&] {
    hdf5({{"time", times, "jiffies"}, {"force", forces, "N"}});
  });
  EXPECT_THAT(unknown.what(), HasSubstr("not known"));
  EXPECT_EQ(unknown.location().value, "jiffies");
  std::vector<WantedColumn> stated = time_and_force;
  stated[0].unit = "ms";
  stated[1].unit = "kN";
  testing::write_matlab(path("b.mat"), {{"time", times}, {"force", forces}});
  expect_the_record(read_laboratory_table(path("b.mat"), stated));
}

TEST_F(ArrayTableTest, FilesOfAnotherKindAreRefused) {
  testing::write_hdf5(path("whole.h5"), {{"time_s", times}, {"force_N", forces}});
  testing::write_matlab(path("whole.mat"), {{"time_s", times}, {"force_N", forces}});
  const std::string hdf5_bytes = testing::read_whole(path("whole.h5"));
  for (const char* name : {"bad.h5", "bad.mat"})
    for (const std::string& bytes :
         {std::string(), std::string("time,force\n1,2\n"), std::string(5000, '\0'),
          hdf5_bytes.substr(0, hdf5_bytes.size() / 2)}) {
      folder.write(name, bytes);
      const Error error = refusal_of([&] { read_laboratory_table(path(name), time_and_force); });
      EXPECT_EQ(error.code(), ExitCode::bad_input) << name << bytes.size();
      EXPECT_EQ(error.location().file, path(name).string());
    }
  EXPECT_EQ(refusal_of([&] { read_laboratory_table(path("none.h5"), time_and_force); }).code(),
            ExitCode::input_output_failed);
}

/// Whatever a changed byte does, the answer is numbers or an error: never a crash.
TEST_F(ArrayTableTest, ChangedBytesGiveNumbersOrAnError) {
  testing::write_hdf5(path("whole.h5"), {{"time_s", times}, {"force_N", forces}});
  testing::write_matlab(path("whole.mat"), {{"time_s", times}, {"force_N", forces}});
  std::mt19937 random(5);
  int refused = 0, read = 0;
  for (const char* name : {"whole.h5", "whole.mat"}) {
    const std::string whole = testing::read_whole(path(name));
    const std::string changed = name[6] == 'h' ? "changed.h5" : "changed.mat";
    for (int i = 0; i < 60; ++i) {
      std::string bytes = whole;
      for (int k = 0; k < 1 + i % 4; ++k)
        bytes[random() % bytes.size()] = static_cast<char>(random());
      if (i % 5 == 0) bytes.resize(random() % bytes.size());
      folder.write(changed, bytes);
      try {
        const auto table = read_laboratory_table(folder.path() / changed, time_and_force);
        EXPECT_EQ(table.columns[1].numbers.size(), table.lines.size());
        ++read;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input) << error.what();
        EXPECT_FALSE(error.location().file.empty()) << error.what();
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(read, 20);
}

TEST_F(ArrayTableTest, APreviewTellsChannelsFromTheRest) {
  testing::write_matlab(path("p.mat"),
                        {{"time_s", times},
                         {"force_N", forces},
                         {"rate_Hz", {2e5}},
                         {.name = "both", .values = {1, 2, 3, 4, 5, 6}, .columns = 2}});
  const TablePreview preview = preview_table(path("p.mat"));
  EXPECT_EQ(preview.rows, 3u);
  EXPECT_EQ(preview.heading_line, 0);
  ASSERT_EQ(preview.headings.size(), 4u);
  EXPECT_EQ(preview.headings[1].unit, "N");
  EXPECT_THAT(preview.is_number, ElementsAre(true, true, false, false));
}

}  // namespace
}  // namespace rebound
