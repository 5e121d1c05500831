// MATLAB and HDF5 files that are damaged, of another kind, or hold what is no record: refused with
// file and variable by `inspect` and `init dataset`, and nothing is written.
#include <hdf5.h>

#include <cstdint>
#include <functional>
#include <limits>

#include "tests/cli/program.hpp"
#include "tests/support/write_arrays.hpp"

namespace rebound::testing {
namespace {

enum class Kind { matlab5, matlab73, hdf5 };

const char* file_of(Kind kind) {
  return kind == Kind::hdf5 ? "t.h5" : "t.mat";
}

void write(Kind kind, const std::filesystem::path& file, const std::vector<WrittenArray>& arrays) {
  if (kind == Kind::hdf5) return write_hdf5(file, arrays);
  write_matlab(file, arrays,
               kind == Kind::matlab5 ? MatlabVersion::five : MatlabVersion::seven_three);
}

using Arrays = std::vector<WrittenArray>;

Arrays record() {
  WrittenArray time{"time_ms", {}}, force{"force_N", {}};
  for (int i = 0; i < 200; ++i) {
    time.values.push_back(0.01 * i);
    force.values.push_back(i % 7);
  }
  return {time, force};
}

struct Fault {
  const char* name;
  std::function<void(Arrays&)> arrays;      ///< done before the file is written
  std::function<void(std::string&)> bytes;  ///< and after
  const char* part;                         ///< of the message
};

const std::vector<Fault> faults = {
    {"Empty", {}, [](std::string& bytes) { bytes.clear(); }, ""},
    {"Truncated", {}, [](std::string& bytes) { bytes.resize(bytes.size() / 2); }, ""},
    {"Corrupt",
     {},
     [](std::string& bytes) {
       for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 600); ++i)
         bytes[i] = static_cast<char>(bytes[i] ^ 0x5a);
     },
     ""},
    {"APicture",
     {},
     [](std::string& bytes) { bytes = "\x89PNG\r\n\x1a\n" + std::string(1000, '\x11'); },
     ""},
    {"ATextFile", {}, [](std::string& bytes) { bytes = "time [ms],force [N]\n0,1\n1,2\n"; }, ""},
    {"AnotherUnit", [](Arrays& a) { a[1].name = "force_mm"; }, {}, "force_mm"},
    {"NoUnit", [](Arrays& a) { a[1].name = "force"; }, {}, "states no unit"},
    {"NaN",
     [](Arrays& a) { a[1].values[42] = std::numeric_limits<double>::quiet_NaN(); },
     {},
     "element 43 is not finite"},
    {"TimeBackwards",
     [](Arrays& a) { std::swap(a[0].values[10], a[0].values[11]); },
     {},
     "element 12 does not increase"},
    {"AMatrix", [](Arrays& a) { a[1].columns = 2; }, {}, "no vector"},
    {"OtherLengths", [](Arrays& a) { a[1].values.pop_back(); }, {}, "not as long"},
    {"NotThere", [](Arrays& a) { a[1].name = "kraft_N"; }, {}, "missing"}};

class BadArrays : public ProgramTest,
                  public ::testing::WithParamInterface<std::tuple<Kind, std::size_t>> {
 protected:
  /// `inspect` of a data set whose trace stands in `file`.
  Outcome inspected(const std::string& file) const {
    std::filesystem::create_directories(folder.path() / "data");
    std::filesystem::rename(folder.path() / file, folder.path() / "data" / file);
    folder.write("data/dataset.toml",
                 "schema = 1\nname = \"b\"\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n"
                 "[channels]\ntime = \"time\"\nforce = \"force\"\n[[shot]]\nspeed = \"5 m/s\"\n"
                 "trace = \"" +
                     file + "\"\n");
    return rebound({"inspect", "data", "--out", "page"});
  }
};

TEST_P(BadArrays, AreRefusedWithFileAndVariable) {
  const auto [kind, number] = GetParam();
  const Fault& fault = faults[number];
  const std::string file = file_of(kind);
  Arrays arrays = record();
  if (fault.arrays) fault.arrays(arrays);
  write(kind, folder.path() / file, arrays);
  if (fault.bytes) {
    std::string bytes = read_whole(folder.path() / file);
    fault.bytes(bytes);
    folder.write(file, bytes);
    const Outcome init = rebound({"init", "dataset", "--from", file, "--out", "ball"});
    EXPECT_EQ(init.exit_code, 2) << init.output;
    EXPECT_NE(init.errors.find(file), std::string::npos) << init.errors;
    EXPECT_FALSE(there("ball"));
  }
  const Outcome outcome = inspected(file);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_EQ(outcome.output, "");
  EXPECT_NE(outcome.errors.find(file), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find(fault.part), std::string::npos) << outcome.errors;
  EXPECT_FALSE(there("page"));
}

std::string name_of_case(const ::testing::TestParamInfo<std::tuple<Kind, std::size_t>>& one) {
  const auto [kind, number] = one.param;
  const char* file = kind == Kind::matlab5    ? "Matlab5"
                     : kind == Kind::matlab73 ? "Matlab73"
                                              : "Hdf5";
  return std::string(file) + faults[number].name;
}

INSTANTIATE_TEST_SUITE_P(Every, BadArrays,
                         ::testing::Combine(::testing::Values(Kind::matlab5, Kind::matlab73,
                                                              Kind::hdf5),
                                            ::testing::Range<std::size_t>(0, faults.size())),
                         name_of_case);

/// Two variables of version 4, each with the numbers of rows and columns that are claimed.
std::string level4(std::uint32_t rows, std::uint32_t columns) {
  std::string bytes;
  for (const std::string& name : {std::string("time_ms"), std::string("force_N")}) {
    for (const std::uint32_t word :
         {0u, rows, columns, 0u, static_cast<std::uint32_t>(name.size() + 1)})
      bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    bytes += name + '\0';
    bytes.append(8, '\0');
  }
  return bytes;
}

class BillionColumns : public BadArrays {};

TEST_F(BillionColumns, OfAMatlabFileAreRefused) {
  folder.write("t.mat", level4(1, 1'000'000'000));
  const Outcome outcome = inspected("t.mat");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_NE(outcome.errors.find("t.mat"), std::string::npos) << outcome.errors;
  EXPECT_FALSE(there("page"));
}

TEST_F(BillionColumns, OfAnHdf5FileAreRefusedWithTheirVariable) {
  const hid_t file =
      H5Fcreate((folder.path() / "t.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t shape[] = {1, 1'000'000'000}, chunk[] = {1, 1024};
  const hid_t space = H5Screate_simple(2, shape, nullptr), plan = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(plan, 2, chunk);  // nothing of it is there
  for (const char* name : {"time_ms", "force_N"})
    H5Dclose(H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, plan, H5P_DEFAULT));
  H5Pclose(plan);
  H5Sclose(space);
  H5Fclose(file);
  const Outcome outcome = inspected("t.h5");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_NE(outcome.errors.find("t.h5: time_ms: the data set has more than 10000000 numbers"),
            std::string::npos)
      << outcome.errors;
  EXPECT_FALSE(there("page"));
}

}  // namespace
}  // namespace rebound::testing
