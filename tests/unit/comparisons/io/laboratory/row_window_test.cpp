#include "comparisons/io/laboratory/row_window.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// Rows of a record of `length` with one swing of five rows at `place`, read through a window.
LaboratoryTable read_window(std::size_t length, std::size_t place, const KeptRows& kept,
                            bool last_line_ends = true) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "record.csv";
  {
    std::ofstream out(file);
    out << "time_s,force_N\n";
    for (std::size_t i = 0; i < length; ++i) {
      const double swing =
          i >= place && i < place + 5 ? 3.0 - std::abs(2.0 - double(i - place)) : 0.0;
      out << i << "," << 7.0 + 0.01 * double(i * 7 % 5) - 10.0 * swing;
      if (i + 1 < length || last_line_ends) out << "\n";
    }
  }
  return read_laboratory_table(file,
                               {{.heading = "time", .accepted = {dimension::time}},
                                {.heading = "force", .accepted = {dimension::force}}},
                               kept);
}

TEST(RowWindowTest, KeepsTheRowsAroundTheLargestSwing) {
  const KeptRows kept{.column = 1, .before = 20, .after = 10};
  for (const std::size_t place : {0u, 3u, 19u, 20u, 50u, 100u, 480u, 495u}) {
    const LaboratoryTable table = read_window(500, place, kept);
    const std::size_t peak = place + 2;
    const std::size_t first = peak > 20 ? peak - 20 : 0,
                      last = std::min<std::size_t>(499, peak + 10);
    EXPECT_EQ(table.rows_read, 500u);
    EXPECT_EQ(table.columns[0].numbers.front(), double(first)) << place;
    EXPECT_EQ(table.columns[0].numbers.back(), double(last)) << place;
    EXPECT_EQ(table.columns[0].numbers.size(), last - first + 1) << place;
    EXPECT_EQ(table.lines.size(), table.columns[1].numbers.size());
    EXPECT_EQ(table.lines.front(), int(first) + 2);  // the heading is line 1
    EXPECT_LT(table.columns[1].numbers[peak - first], -20.0);
  }
}

TEST(RowWindowTest, AShortTableStaysAsItIs) {
  const LaboratoryTable table = read_window(30, 10, {.column = 1, .before = 100, .after = 100});
  EXPECT_EQ(table.columns[0].numbers.size(), 30u);
  EXPECT_EQ(table.rows_read, 30u);
}

// A last row that may be cut off is left out of what is kept, and only there.
TEST(RowWindowTest, ARowThatMayBeCutOff) {
  const KeptRows kept{.column = 1, .before = 20, .after = 10};
  EXPECT_EQ(read_window(100, 93, kept, false).columns[0].numbers.back(), 98.0);
  EXPECT_EQ(read_window(100, 40, kept, false).columns[0].numbers.back(), 52.0);
}

}  // namespace
}  // namespace rebound
