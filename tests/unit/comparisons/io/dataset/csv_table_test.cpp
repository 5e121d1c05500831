#include "comparisons/io/dataset/csv_table.hpp"

#include <sys/resource.h>

#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;
using testing::TemporaryFolder;

const CsvRequest trace{
    .needed = {"time_s", "force_N"}, .optional = {"deflection_m"}, .increasing = "time_s"};

CsvTable read(const std::string& text) {
  const TemporaryFolder folder;
  return read_csv(folder.write("t.csv", text), trace);
}

TEST(CsvTableTest, ReadsColumnsInAnyOrderAndPassesOverOthers) {
  const CsvTable table = read("# made by hand\nforce_N, note_x ,time_s\n1,9,0\n+2.5e1,9,1e-3\n");
  EXPECT_EQ(*table.column("time_s"), (std::vector<double>{0.0, 1e-3}));
  EXPECT_EQ(*table.column("force_N"), (std::vector<double>{1.0, 25.0}));
  EXPECT_EQ(table.column("deflection_m"), nullptr);
}

TEST(CsvTableTest, ByteOrderMarkAndWindowsLineEndsDoNotShow) {
  const CsvTable table = read("\xef\xbb\xbftime_s,force_N\r\n0,1\r\n1,2\r\n");
  EXPECT_EQ(*table.column("force_N"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(table.left_out_line, 0);
}

TEST(CsvTableTest, ALastRowThatMayBeCutOffIsLeftOutAndReported) {
  const CsvTable table = read("time_s,force_N\n0,1\n1,2\n2,35");
  EXPECT_EQ(*table.column("force_N"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(table.left_out_line, 4);
}

struct Refused {
  const char* name;
  std::string text;
  int line;
  const char* part;
};

class CsvTableRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(CsvTableRefuses, WithFileLineAndReason) {
  const Refused& c = GetParam();
  const Error error = refusal_of([&] { read(c.text); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(error.location().file.find("t.csv"), std::string::npos);
  EXPECT_EQ(error.location().line, c.line);
  EXPECT_NE(std::string(error.what()).find(c.part), std::string::npos) << error.what();
}

const std::string header = "time_s,force_N\n";

INSTANTIATE_TEST_SUITE_P(
    Cases, CsvTableRefuses,
    ::testing::Values(Refused{"Empty", "", 0, "empty"}, Refused{"NoRows", header, 1, "no rows"},
                      Refused{"MissingColumn", "time_s,load\n0,1\n", 1, "missing"},
                      Refused{"DuplicateColumn", "time_s,force_N,time_s\n0,1,2\n", 1, "twice"},
                      Refused{"Ragged", header + "0,1\n1\n2,3\n", 3, "1 fields, the header 2"},
                      Refused{"TooManyFields", header + "0,1\n1,2,3\n", 3, "3 fields"},
                      Refused{"DecimalComma", header + "0,1\n0,5,2\n", 3, "3 fields"},
                      Refused{"Text", header + "0,1\n1,two\n", 3, "no number"},
                      Refused{"Blank", header + "0,1\n1,\n", 3, "no number"},
                      Refused{"NaN", header + "0,1\n1,nan\n", 3, "finite"},
                      Refused{"Infinite", header + "0,1\n1,-inf\n", 3, "finite"},
                      Refused{"TooLarge", header + "0,1\n1,1e999\n", 3, "no number"},
                      Refused{"TimeBack", header + "0,1\n2,1\n1,1\n", 4, "does not increase"},
                      Refused{"TimeStill", header + "0,1\n1,1\n1,1\n", 4, "does not increase"},
                      Refused{"Nul",
                              header + std::string("0,1\n1,\0"
                                                   "2\n",
                                                   9),
                              3, "NUL"},
                      Refused{"LongLine", header + "0,1\n1," + std::string(1000000, '1') + "\n", 3,
                              "longer"},
                      Refused{"LongHeader", std::string(1000000, 'x'), 1, "longer"},
                      Refused{"CutOff", header + "0,1\n1,2\n2", 4, "cut off"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(CsvTableTest, AFolderOrMissingFileCannotBeRead) {
  EXPECT_EQ(refusal_of([] { read_csv("/", trace); }).code(), ExitCode::input_output_failed);
  EXPECT_EQ(refusal_of([] { read_csv("/no/such.csv", trace); }).code(),
            ExitCode::input_output_failed);
}

TEST(CsvTableTest, ColumnsNobodyAskedForTakeNoMemory) {
  // 200 columns of 5000 rows are 20 MB of text; two of them are 80 kB.
  std::string text = header.substr(0, header.size() - 1);
  for (int i = 0; i < 200; ++i) text += ",c" + std::to_string(i);
  text += "\n";
  std::string tail;
  for (int i = 0; i < 200; ++i) tail += ",0.12345678901234567";
  const TemporaryFolder folder;
  {
    std::ofstream stream(folder.path() / "t.csv");
    stream << text;
    for (int i = 0; i < 5000; ++i) stream << i << ",1" << tail << "\n";
  }
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(read_csv(folder.path() / "t.csv", trace).columns[0].size(), 5000u);
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 4096);  // kB
}

}  // namespace
}  // namespace rebound
