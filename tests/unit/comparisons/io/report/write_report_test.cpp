#include "comparisons/io/report/write_report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "comparisons/io/report/json.hpp"
#include "comparisons/io/report/page.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/io/report/demo_report.hpp"

namespace rebound::report {
namespace {

namespace fs = std::filesystem;

class WriteReport : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("write-report-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  long files_in_folder() const {
    return std::distance(fs::recursive_directory_iterator(folder_), {});
  }

  fs::path folder_;
};

TEST_F(WriteReport, WritesThePageAndNothingElse) {
  const Report report = report_tests::demo_report();
  write_report(report, folder_ / "report.html");
  EXPECT_EQ(content_of(folder_ / "report.html"), page_html(report.title, report_json(report)));
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(WriteReport, MakesFoldersOnTheWay) {
  write_report(report_tests::demo_report(), folder_ / "a" / "b" / "report.html");
  EXPECT_TRUE(fs::exists(folder_ / "a" / "b" / "report.html"));
}

TEST_F(WriteReport, ARefusedReportLeavesTheOldFile) {
  std::ofstream(folder_ / "report.html") << "old";
  Report report = report_tests::demo_report();
  report.headline.clear();
  EXPECT_THROW(write_report(report, folder_ / "report.html"), Error);
  EXPECT_EQ(content_of(folder_ / "report.html"), "old");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(WriteReport, SaysWhichFileCannotBeWritten) {
  fs::create_directories(folder_ / "report.html" / "in the way");
  try {
    write_report(report_tests::demo_report(), folder_ / "report.html");
    FAIL() << "replaced a folder";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input_output_failed);
    EXPECT_EQ(error.location().file, (folder_ / "report.html").string());
  }
  EXPECT_EQ(files_in_folder(), 2) << "a temporary file is left";
}

}  // namespace
}  // namespace rebound::report
