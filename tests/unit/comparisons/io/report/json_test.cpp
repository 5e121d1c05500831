#include "comparisons/io/report/json.hpp"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/io/report/demo_report.hpp"

namespace rebound::report {
namespace {

TEST(ReportJson, CarriesItsSchemaAndEveryBlockItsKind) {
  const nlohmann::json object = report_json(report_tests::demo_report());
  EXPECT_EQ(object.at("schema"), 1);
  std::set<std::string> kinds;
  for (const auto& section : object.at("sections")) {
    for (const auto& block : section.at("blocks")) kinds.insert(block.at("kind"));
  }
  const std::set<std::string> expected{"animation", "figure",    "matrix", "notice",
                                       "overlays",  "paragraph", "table",  "verbatim"};
  EXPECT_EQ(kinds, expected);
}

TEST(ReportJson, DrawnNumbersKeepFiveDigitsAndStayFinite) {
  Report report{.title = "t", .subtitle = "", .headline = "h", .notices = {}, .sections = {}};
  Series series;
  series.name = "s";
  series.x = {0.1, 1.0 / 3.0, 6.02214076e23};
  series.y = {5e-324, -0.0, 1.7976931348623157e308};
  Figure figure{.title = "f", .caption = "", .x = {"x", "m"}, .y = {"y", "N"}, .series = {series}};
  report.sections = {{"s", Section::Folding::open, {figure}}};
  const auto back = nlohmann::json::parse(report_json(report).dump());
  const auto& drawn = back.at("sections")[0].at("blocks")[0].at("series")[0];
  EXPECT_EQ(drawn.at("x").get<std::vector<double>>(),
            (std::vector<double>{0.1, 0.33333, 6.0221e23}));
  // At the ends of the range five digits could be beyond it.
  EXPECT_EQ(drawn.at("y").get<std::vector<double>>(), series.y);
}

TEST(ReportJson, SaysWhereEachNumberIsFrom) {
  const Origin origins[] = {Origin::measured, Origin::derived, Origin::fitted, Origin::predicted};
  const char* words[] = {"measured", "derived", "fitted", "predicted"};
  Table table{.title = "t", .caption = "", .columns = {}, .rows = {}};
  for (const Origin origin : origins)
    table.columns.push_back({"c", "1", TableColumn::Kind::number, origin});
  table.columns.push_back({"c"});
  const Report report{.title = "t",
                      .subtitle = "",
                      .headline = "h",
                      .notices = {},
                      .sections = {{"s", Section::Folding::open, {table}}}};
  const auto columns = report_json(report)["sections"][0]["blocks"][0]["columns"];
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(columns[i]["origin"], words[i]);
  EXPECT_TRUE(columns[4]["origin"].is_null());
}

TEST(ReportJson, EvidenceAndDetailsStandWithWhatTheyBelongTo) {
  const auto object = report_json(report_tests::demo_report());
  const auto& checks = object["sections"][2];
  EXPECT_EQ(checks["blocks"][2]["evidence"], "Measured 3.1 mm, made-up reference 2.5 mm.");
  ASSERT_EQ(checks["details"].size(), 1u);
  EXPECT_EQ(checks["details"][0]["rows"][0][0]["link"], "pages/one.html");
}

TEST(ReportJson, MatrixCellWithoutAValueIsNull) {
  const auto object = report_json(report_tests::demo_report());
  const auto cell = object["sections"][0]["blocks"][0]["rows"].back()["cells"].back();
  EXPECT_TRUE(cell.at("value").is_null());
  EXPECT_EQ(cell.at("text"), "not run");
}

}  // namespace
}  // namespace rebound::report
