#include "comparisons/io/laboratory/laboratory_table.hpp"

#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

using testing::refusal_of;
using testing::TemporaryFolder;

const std::vector<WantedColumn> trace{
    {.heading = "Time", .accepted = {dimension::time}, .increases = true},
    {.heading = "Force", .accepted = {dimension::force, dimension::acceleration}}};

LaboratoryTable read(const std::string& text) {
  const TemporaryFolder folder;
  return read_laboratory_table(folder.write("t.csv", text), trace);
}

struct Accepted {
  const char* name;
  std::string text;
};

/// However it is written, it is the same table: 0 and 1 ms, -1 and 2.5 kN.
class LaboratoryTableReads : public ::testing::TestWithParam<Accepted> {};

TEST_P(LaboratoryTableReads, TheSameNumbers) {
  const LaboratoryTable table = read(GetParam().text);
  ASSERT_EQ(table.columns[0].numbers.size(), 2u);
  EXPECT_DOUBLE_EQ(table.columns[0].numbers[1], 1e-3);
  EXPECT_DOUBLE_EQ(table.columns[1].numbers[0], -1000.0);
  EXPECT_DOUBLE_EQ(table.columns[1].numbers[1], 2500.0);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, LaboratoryTableReads,
    ::testing::Values(
        Accepted{"Commas", "Time [ms],Force [kN]\n0,-1\n1,2.5\n"},
        Accepted{"Semicolons", "Time (ms);Force (kN)\n0;-1\n1;2.5\n"},
        Accepted{"Tabulators", "Time / s\tForce / N\n0\t-1e3\n1e-3\t+2500\n"},
        Accepted{"DecimalCommas", "Time_ms;Force_kN\n0,0;-1,0\n1,0;2,5\n"},
        Accepted{"MarkAndWindowsLineEnds",
                 "\xef\xbb\xbfTime_us,Force_N\r\n0,-1000\r\n1000,2500\r\n"},
        Accepted{"RowOfUnits", "Time;Force\n(ms);[kN]\n0;-1\n1;2.5\n"},
        Accepted{"LinesAbove", "Recorder 7;2024\nSample;A\nTime [ms];Force [kN]\n0;-1\n1;2.5\n"},
        Accepted{"Comments",
                 "# made by hand\n% more\nTime [ms],Force [kN]\n\n0,-1\n# a pause\n1,2.5\n"},
        Accepted{"FurtherColumns", "Note,Force [kN],Time [ms]\nfine,-1,0\n\"so, so\",2.5,1\n"},
        Accepted{"Quotes",
                 "\"Day, hour\",\"Time [ms]\",\"Force [kN]\"\n0,0.000 ,\"-1\"\n1,1,2.5\n"},
        Accepted{"TrailingSeparators", "Time [ms];Force [kN]\n0;-1;;\n1;2.5;;\n"}),
    [](const auto& c) { return std::string(c.param.name); });

TEST(LaboratoryTableTest, AnAccelerationInMultiplesOfFreeFall) {
  const LaboratoryTable table = read("Time [s],Force [g]\n0,1\n1,2\n");
  EXPECT_DOUBLE_EQ(table.columns[1].numbers[0], 9.80665);
  EXPECT_TRUE(same_dimension(table.columns[1].dimension, dimension::acceleration));
}

TEST(LaboratoryTableTest, ALastRowThatMayBeCutOffIsLeftOutAndTold) {
  const LaboratoryTable table = read("Time [s],Force [N]\n0,1\n1,2\n2,35");
  EXPECT_EQ(table.columns[1].numbers.size(), 2u);
  EXPECT_EQ(table.lines.size(), 2u);
  EXPECT_EQ(table.left_out_line, 4);
}

struct Refused {
  const char* name;
  std::string text;
  int line;
  int column;
  const char* part;
};

class LaboratoryTableRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(LaboratoryTableRefuses, WithFileLineColumnAndReason) {
  const Refused& c = GetParam();
  const Error error = refusal_of([&] { read(c.text); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(error.location().file.find("t.csv"), std::string::npos);
  EXPECT_EQ(error.location().line, c.line) << error.what();
  EXPECT_EQ(error.location().column, c.column) << error.what();
  EXPECT_NE(std::string(error.what()).find(c.part), std::string::npos) << error.what();
}

std::string many_columns() {
  std::string text = "Time [s];Force [N]";
  for (int i = 0; i < 5000; ++i) text += ";c";
  return text + "\n";
}

const std::string head = "Time [s],Force [N]\n";
const std::string semicolons = "Time [s];Force [N]\n";

INSTANTIATE_TEST_SUITE_P(
    Cases, LaboratoryTableRefuses,
    ::testing::Values(
        Refused{"Empty", "", 0, 0, "empty"}, Refused{"NoRows", head, 1, 0, "no rows"},
        Refused{"MissingColumn", "Time [s],Kraft [N]\n0,1\n", 1, 0, "missing"},
        Refused{"ColumnTwice", "Time [s],Force [N],Force [kN]\n0,1,1\n", 1, 1, "twice"},
        Refused{"NoUnit", "Time [s],Force\n0,1\n", 1, 0, "no unit"},
        Refused{"AnotherUnit", "Time [mm],Force [N]\n0,1\n", 1, 0, "another unit"},
        Refused{"UnknownUnit", "Time,Force\n(ms),(furlong)\n0,1\n", 1, 0, "no unit"},
        Refused{"NaN", head + "0,1\n1,nan\n", 3, 3, "finite"},
        Refused{"Infinite", head + "0,1\n1,inf\n", 3, 3, "finite"},
        Refused{"TooLarge", head + "0,1\n1,1e999\n", 3, 3, "no number"},
        Refused{"NothingThere", semicolons + "0;1\n1;;\n", 3, 3, "missing here"},
        Refused{"Text", head + "0,1\n1, broken\n", 3, 4, "no number"},
        Refused{"DecimalCommasBesideCommas", head + "0,5,1,5\n", 2, 1, "decimal commas"},
        Refused{"MixOfMarks", semicolons + "0,5;1\n1.5;2\n", 3, 1, "no number"},
        Refused{"ThousandsMark", semicolons + "0;1.000,5\n", 2, 3, "no number"},
        Refused{"ShortRow", head + "0,1\n1\n", 3, 1, "1 fields"},
        Refused{"CutOff", head + "0,1\n1,2\n2", 4, 1, "cut off"},
        Refused{"TimeGoesBack", head + "0,1\n2,1\n1,1\n", 4, 1, "does not increase"},
        Refused{"TimeStandsStill", head + "0,1\n0,1\n", 3, 1, "does not increase"},
        Refused{"Nul", head + std::string("0,1\n1,\0\n", 8), 3, 0, "NUL"},
        Refused{"WideEncoding", "\xff\xfeT\n", 1, 0, "UTF-16"},
        Refused{"LongLine", head + std::string(100000, '1') + "\n", 2, 0, "longer"},
        Refused{"ManyColumns", many_columns(), 1, 0, "columns"}),
    [](const auto& c) { return std::string(c.param.name); });

TEST(LaboratoryTableTest, APreviewTellsHeadingUnitsAndWhatIsText) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "t.csv", "Recorder;7\nball;Drop;Rebound [cm]\n;cm;\nred;80;63,8\nblue;90;72,0\n");
  const TablePreview preview = preview_table(file);
  EXPECT_EQ(preview.heading_line, 2);
  EXPECT_EQ(preview.rows, 2u);
  ASSERT_EQ(preview.headings.size(), 3u);
  EXPECT_EQ(preview.headings[1].unit, "cm");
  EXPECT_EQ(preview.headings[2].name, "Rebound");
  EXPECT_EQ(preview.is_number, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(preview.dialect.decimal_mark, ',');
  EXPECT_EQ(refusal_of([&] { preview_table(folder.write("n.csv", "1,2\n3,4\n")); }).code(),
            ExitCode::bad_input);
}

TEST(LaboratoryUnitsTest, HeadingsAreTakenApart) {
  const auto parts = [](const char* text) {
    const ColumnHeading heading = parse_heading(text);
    return heading.name + "|" + heading.unit;
  };
  EXPECT_EQ(parts("force_N"), "force|N");
  EXPECT_EQ(parts("speed_m_s"), "speed|m_s");
  EXPECT_EQ(parts("v (m/s)"), "v|m/s");
  EXPECT_EQ(parts("inbound_mph"), "inbound|mph");
  EXPECT_EQ(parts("rebound_sd_cm"), "rebound_sd|cm");
  EXPECT_EQ(parts("shot_1"), "shot_1|");
  EXPECT_EQ(parts("Force [?]"), "Force [?]|");
}

TEST(LaboratoryUnitsTest, FactorsAreThoseOfTheirDefinitions) {
  EXPECT_DOUBLE_EQ(find_unit("mph")->factor, 0.44704);
  EXPECT_DOUBLE_EQ(find_unit("lbf")->factor, 4.4482216152605);
  EXPECT_DOUBLE_EQ(find_unit("in")->factor, 0.0254);
  EXPECT_DOUBLE_EQ(find_unit("mil")->factor, 25.4e-6);
  EXPECT_DOUBLE_EQ(find_unit("yd")->factor, 0.9144);
  EXPECT_DOUBLE_EQ(find_unit("ozf")->factor, 0.45359237 / 16.0 * 9.80665);
  EXPECT_DOUBLE_EQ(find_unit("gf")->factor, 0.00980665);
  EXPECT_DOUBLE_EQ(find_unit("dyn")->factor, 1e-5);
  EXPECT_DOUBLE_EQ(find_unit("km/h")->factor, 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(find_unit("g")->factor, 1e-3);
  for (const char* text : {"m/s\u00b2", "m/s2", "m s^-2", "m/s^2", "m_s2"}) {
    ASSERT_TRUE(find_unit(text)) << text;
    EXPECT_TRUE(same_dimension(find_unit(text)->dimension, dimension::acceleration)) << text;
  }
  EXPECT_FALSE(find_unit("furlong"));
  EXPECT_FALSE(find_unit(""));
}

}  // namespace
}  // namespace rebound
