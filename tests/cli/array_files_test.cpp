// MATLAB and HDF5 files from `init dataset` to `inspect`, and tables of campaigns, as a user meets
// them.
#include <hdf5.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/support/write_arrays.hpp"

namespace rebound::testing {
namespace {

/// Half a sine of 1.5 ms and 2000 N in a record of 6 ms, with a ripple for noise.
struct Record {
  std::vector<double> time_ms, force_kn;
  Record() {
    for (int i = 0; i < 600; ++i) {
      const double t = 1e-2 * i, in = t - 2.0;
      time_ms.push_back(t);
      force_kn.push_back(in > 0.0 && in < 1.5 ? 2.0 * std::sin(std::numbers::pi * in / 1.5) : 0.0);
      force_kn.back() += 5e-3 * (i * i % 7 - 3);
    }
  }
};

class ArrayFiles : public ProgramTest {
 protected:
  /// What `inspect` says of the shot in a file.
  nlohmann::json inspected(const std::string& file) const {
    const Outcome init = rebound({"init", "dataset", "--from", file, "--mass", "89.6 g",
                                  "--diameter", "66.2 mm", "--speed", "15 m/s", "--out", "ball"});
    EXPECT_EQ(init.exit_code, 0) << init.errors;
    const Outcome outcome = rebound({"inspect", "ball", "--json"});
    EXPECT_EQ(outcome.exit_code, 0)
        << outcome.errors << read_whole(folder.path() / "ball/dataset.toml");
    std::filesystem::remove_all(folder.path() / "ball");
    return nlohmann::json::parse(outcome.output, nullptr, false)["shots"][0];
  }

  const Record record;
};

TEST_F(ArrayFiles, ARecordGivesTheSameWhateverItStandsIn) {
  std::string text = "time [ms],force [kN]\n";
  for (std::size_t i = 0; i < record.time_ms.size(); ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%.17g,%.17g\n", record.time_ms[i], record.force_kn[i]);
    text += line;
  }
  folder.write("r.csv", text);
  const std::vector<WrittenArray> named{
      {"time_ms", record.time_ms}, {"force_kN", record.force_kn}, {"mass_g", {89.6}}};
  write_matlab(folder.path() / "r5.mat", named);
  write_matlab(folder.path() / "r73.mat", named, MatlabVersion::seven_three);
  write_hdf5(folder.path() / "r.h5",
             {{"scope/time", record.time_ms, "ms"}, {"scope/force", record.force_kn, "kN"}});
  const auto as_text = inspected("r.csv");
  EXPECT_NEAR(as_text["numbers"]["peak_force_N"]["value"].get<double>(), 2000.0, 20.0);
  for (const char* file : {"r5.mat", "r73.mat", "r.h5"})
    EXPECT_EQ(inspected(file), as_text) << file;
}

TEST_F(ArrayFiles, GuessesAreMarkedAndWhatIsBadIsNamed) {
  write_matlab(folder.path() / "r.mat", {{"t", record.time_ms}, {"F", record.force_kn}});
  ASSERT_EQ(rebound({"init", "dataset", "--from", "r.mat", "--mass", "89.6 g", "--diameter",
                     "66.2 mm", "--speed", "15 m/s"})
                .exit_code,
            0);
  const std::string manifest = read_whole(folder.path() / "r/dataset.toml");
  for (const char* part : {"time = \"t\"", "force = \"F\"", "time_unit = \"s\"", "# GUESSED",
                           "2 variables, the longest of 600 numbers"})
    EXPECT_NE(manifest.find(part), std::string::npos) << part << "\n" << manifest;
  const auto said = [&](const std::string& text) {
    folder.write("r/dataset.toml", text);
    const Outcome outcome = rebound({"inspect", "r", "--out", "page"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_FALSE(there("page"));
    return outcome.errors;
  };
  const std::string other = said(replaced(manifest, "force = \"F\"", "force = \"G\""));
  EXPECT_NE(other.find("r.mat: G = t | F: the variable is missing"), std::string::npos) << other;
  const std::string none = said(replaced(manifest, "time_unit = \"s\"", "# none"));
  EXPECT_NE(none.find("states no unit"), std::string::npos) << none;
  EXPECT_NE(none.find("r.mat: t"), std::string::npos) << none;
  folder.write("words.h5", "no arrays");
  const Outcome words = rebound({"init", "dataset", "--from", "words.h5"});
  EXPECT_EQ(words.exit_code, 2);
  EXPECT_NE(words.errors.find("words.h5"), std::string::npos) << words.errors;
  EXPECT_FALSE(there("words"));
}

/// Numbers of a data set and, of fixed-length texts, the texts.
std::vector<double> numbers_in(const std::filesystem::path& file, const char* name) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(opened, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(opened);
  return values;
}
std::string text_in(const std::filesystem::path& file, const char* name) {
  const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(opened, name, H5P_DEFAULT);
  const hid_t type = H5Dget_type(data);
  const hid_t space = H5Dget_space(data);
  std::string text(
      H5Tget_size(type) * static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), ' ');
  EXPECT_GE(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), 0);
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(data);
  H5Fclose(opened);
  return text;
}

TEST_F(ArrayFiles, ACampaignIsQueriedToHdf5AsToCsv) {
  folder.write("ball.toml", lumped_file);
  const std::string campaign =
      "schema = 1\nbase = \"ball.toml\"\n[design]\nkind = \"grid\"\n[[design.factor]]\n"
      "key = \"sphere.diameter\"\nvalues = [\"66.2 mm\", \"70 mm\", \"400 mm\"]\n";
  folder.write("sizes.toml", campaign);
  ASSERT_EQ(rebound({"campaign", "sizes.toml", "--out", "store"}).exit_code, 0);
  const Outcome query = rebound({"campaign", "query", "sizes.toml", "--out", "store", "--csv",
                                 "t.csv", "--hdf5", "t.h5", "--json"});
  ASSERT_EQ(query.exit_code, 0) << query.errors << query.output;
  EXPECT_FALSE(there("t.h5.part"));
  const auto file = folder.path() / "t.h5";
  const auto diameters = numbers_in(file, "sphere.diameter");
  const auto restitutions = numbers_in(file, "restitution");
  ASSERT_EQ(restitutions.size(), 3u);
  EXPECT_TRUE(std::isnan(restitutions[2]));
  EXPECT_NE(text_in(file, "failure").find("implies a density"), std::string::npos);
  EXPECT_EQ(text_in(file, "about/campaign"), campaign + '\0');
  std::istringstream csv(read_whole(folder.path() / "t.csv"));
  std::string line;
  std::getline(csv, line);
  for (std::size_t i = 0; i < 2; ++i) {
    std::getline(csv, line);
    std::string member, diameter, restitution;
    std::istringstream cells(line);
    for (std::string* cell : {&member, &diameter, &restitution}) std::getline(cells, *cell, ',');
    EXPECT_EQ(std::stod(diameter), diameters[i]);
    EXPECT_EQ(std::stod(restitution), restitutions[i]);
  }
  EXPECT_EQ(rebound({"campaign", "query", "sizes.toml", "--out", "store", "--hdf5", "none/t.h5"})
                .exit_code,
            4);
  EXPECT_EQ(rebound({"campaign", "sizes.toml", "--hdf5", "t.h5"}).exit_code, 2);
}

}  // namespace
}  // namespace rebound::testing
