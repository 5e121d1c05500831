// Text tables, manifests and stores that are damaged or of another kind: refused with their place,
// nothing is written, and a store stays as it is.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

const std::string manifest =
    "schema = 1\nname = \"b\"\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n"
    "[[shot]]\nspeed = \"5 m/s\"\ntrace = \"t.csv\"\n";

const std::string table = "time [ms],force [N]\n0,1\n1,2\n2,1\n";

struct BadDataset {
  const char* name;
  std::string manifest, table;
  const char* place;
  const char* part;
};

class BadDatasets : public ProgramTest, public ::testing::WithParamInterface<BadDataset> {};

TEST_P(BadDatasets, AreRefusedWithTheirPlace) {
  const BadDataset& c = GetParam();
  std::filesystem::create_directories(folder.path() / "data");
  folder.write("data/dataset.toml", c.manifest);
  folder.write("data/t.csv", c.table);
  const Outcome outcome = rebound({"inspect", "data", "--out", "page"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_EQ(outcome.output, "");
  for (const char* part : {c.place, c.part})
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  EXPECT_FALSE(there("page"));
}

INSTANTIATE_TEST_SUITE_P(
    Manifest, BadDatasets,
    ::testing::Values(BadDataset{"Empty", "", table, "dataset.toml", "schema"},
                      BadDataset{"Truncated", manifest.substr(0, manifest.size() / 2), table,
                                 "dataset.toml:5:", ""},
                      BadDataset{"Corrupt", replaced(manifest, "[sphere]", "[sph\x01\x02re"), table,
                                 "dataset.toml:3:", ""},
                      BadDataset{"AnotherKind", "PK\x03\x04 a workbook", table,
                                 "dataset.toml:1:", ""},
                      BadDataset{"WrongUnit", replaced(manifest, "89.6 g", "89.6 mm"), table,
                                 "dataset.toml:4:", "sphere.mass"},
                      BadDataset{"NaN", replaced(manifest, "\"5 m/s\"", "nan"), table,
                                 "dataset.toml:7:", "shot[0].speed"},
                      BadDataset{"AnotherVersion", replaced(manifest, "schema = 1", "schema = 7"),
                                 table, "dataset.toml:1:", "schema"}),
    [](const auto& c) { return std::string(c.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Table, BadDatasets,
    ::testing::Values(
        BadDataset{"Empty", manifest, "", "t.csv", "empty"},
        BadDataset{"AWorkbook", manifest, std::string("PK\x03\x04\x14\0\x06\0", 8), "t.csv", ""},
        BadDataset{"APicture", manifest, std::string("\x89PNG\r\n\x1a\n\0\0", 10), "t.csv", ""},
        BadDataset{"AWebPage", manifest, "<!DOCTYPE html>\n<html></html>\n", "t.csv:", ""}),
    [](const auto& c) { return std::string(c.param.name); });

/// A store of four members; what is done to it, and what every command says then.
class BadStores : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("ball.toml", lumped_file);
    folder.write("speeds.toml",
                 "schema = 1\nbase = \"ball.toml\"\n[design]\nkind = \"grid\"\n[[design.factor]]\n"
                 "key = \"impact.speed\"\nvalues = [\"1 m/s\", \"2 m/s\", \"3 m/s\"]\n");
    ASSERT_EQ(rebound({"campaign", "speeds.toml", "--out", "store"}).exit_code, 0);
    whole = read_whole(file());
  }
  std::filesystem::path file() const {
    return folder.path() / "store" / "shard-00001-of-00001.sqlite";
  }
  /// Refused with exit 5 and the file's name, by writer and reader; the file stays.
  void expect_refused(const std::string& bytes, const std::string& what) const {
    folder.write("store/shard-00001-of-00001.sqlite", bytes);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"campaign", "speeds.toml", "--out", "store"},
          {"campaign", "query", "speeds.toml", "--out", "store", "--csv", "t.csv"},
          {"campaign", "query", "store", "--csv", "t.csv"}}) {
      const Outcome outcome = rebound(arguments);
      EXPECT_EQ(outcome.exit_code, 5) << what << outcome.output << outcome.errors;
      EXPECT_NE(outcome.errors.find("shard-00001-of-00001.sqlite"), std::string::npos)
          << what << outcome.errors;
      EXPECT_FALSE(there("t.csv")) << what;
    }
    EXPECT_EQ(read_whole(file()), bytes) << what;
  }

  std::string whole;
};

TEST_F(BadStores, AreExitFiveAndStayAsTheyAre) {
  constexpr std::size_t version_byte = 63, application_byte = 71, page = 4096;
  expect_refused("", "empty");
  expect_refused("no store at all", "text");
  expect_refused(whole.substr(0, whole.size() / 2), "truncated");
  expect_refused(whole.substr(0, page - 1), "cut within its first page");
  std::string changed = whole;
  changed[version_byte] = 99;
  expect_refused(changed, "another version");
  changed = whole;
  changed[application_byte] = 1;
  expect_refused(changed, "another kind of SQLite file");
  changed = whole;
  for (std::size_t i = page; i < changed.size(); ++i)
    changed[i] = static_cast<char>(changed[i] ^ 0x5a);
  expect_refused(changed, "all pages but the first");
  changed = whole;
  const std::string program = "0.1.0+";
  const auto at = changed.find(program);
  ASSERT_NE(at, std::string::npos);
  changed[at] = '7';
  expect_refused(changed, "another program");
}

}  // namespace
}  // namespace rebound::testing
