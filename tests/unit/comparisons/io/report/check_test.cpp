#include "comparisons/io/report/check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/io/report/demo_report.hpp"

namespace rebound::report {
namespace {

using report_tests::demo_report;

template <class Record>
Record& first(Report& report) {
  for (Section& section : report.sections) {
    for (Block& block : section.blocks) {
      if (auto* record = std::get_if<Record>(&block)) return *record;
    }
  }
  throw std::logic_error("the demo report has no such block");
}

TEST(CheckReport, AcceptsTheDemo) {
  EXPECT_NO_THROW(check_report(demo_report()));
}

struct Fault {
  const char* name;
  std::function<void(Report&)> seed;
  const char* said;  ///< must occur in the message
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

class RefusedReport : public testing::TestWithParam<Fault> {};

TEST_P(RefusedReport, NamesTheFault) {
  Report report = demo_report();
  GetParam().seed(report);
  try {
    check_report(report);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_NE(std::string(error.what()).find(GetParam().said), std::string::npos) << error.what();
  }
}

Series& band(Report& report) {
  return first<Overlays>(report).items[0].figures[0].series.back();
}

const Fault faults[] = {
    {"NoHeadline", [](Report& r) { r.headline.clear(); }, "headline"},
    {"LinkOut",
     [](Report& r) {
       std::get<Table>(r.sections[2].details[0]).rows[0][0].link = "https://example.org/a.html";
     },
     "no page beside this one"},
    {"LinkUp",
     [](Report& r) {
       std::get<Table>(r.sections[2].details[0]).rows[0][0].link = "../secret.html";
     },
     "no page beside this one"},
    {"FaultInDetails", [](Report& r) { std::get<Table>(r.sections[2].details[0]).columns.clear(); },
     "no columns"},
    {"FaultInLead", [](Report& r) { r.lead = {Table{}}; }, "no title"},
    {"NoSectionTitle", [](Report& r) { r.sections[0].title.clear(); }, "no title"},
    {"NoUnit", [](Report& r) { first<Figure>(r).x.unit.clear(); }, "no unit"},
    {"NoSeries", [](Report& r) { first<Figure>(r).series.clear(); }, "no series"},
    {"TwinSeries", [](Report& r) { first<Figure>(r).series[1].name = "made-up error"; },
     "two series"},
    {"UnequalLengths", [](Report& r) { first<Figure>(r).series[0].y.pop_back(); }, "not as long"},
    {"NotFinite",
     [](Report& r) { first<Figure>(r).series[0].y[1] = std::numeric_limits<double>::quiet_NaN(); },
     "not finite"},
    {"ZeroOnALogarithmicAxis", [](Report& r) { first<Figure>(r).series[0].y[0] = 0.0; },
     "logarithmic"},
    {"ShortErrorBars", [](Report& r) { first<Figure>(r).series[0].y_error = {1.0}; }, "y_error"},
    {"BandMissesLine", [](Report& r) { band(r).y_low[3] = band(r).y[3] + 1.0; }, "enclose"},
    {"HalfABand", [](Report& r) { band(r).y_high.clear(); }, "y_low and y_high"},
    {"MeasuredLine", [](Report& r) { first<Figure>(r).series[1].origin = Origin::measured; },
     "never as a line"},
    {"FrameLacksAVertex", [](Report& r) { first<Animation>(r).frames[1].radius.pop_back(); },
     "vertices"},
    {"CellWithoutVertex", [](Report& r) { first<Animation>(r).cells[0][2] = 100000; }, "not there"},
    {"TimeRunsBack", [](Report& r) { first<Animation>(r).frames[1].time = -1.0; }, "increase"},
    {"FieldLacksAFrame", [](Report& r) { first<Animation>(r).fields[0].values.pop_back(); },
     "one row per frame"},
    {"FieldLacksACell", [](Report& r) { first<Animation>(r).fields[0].values[1].pop_back(); },
     "one value per cell"},
    {"FieldNotFinite",
     [](Report& r) {
       first<Animation>(r).fields[1].values[0][0] = std::numeric_limits<float>::infinity();
     },
     "finite"},
    {"FieldWithoutUnit", [](Report& r) { first<Animation>(r).fields[0].unit.clear(); }, "unit"},
    {"FieldWithoutRange", [](Report& r) { first<Animation>(r).fields[0].high = 0.0; }, "range"},
    {"PressureLacksAFrame", [](Report& r) { first<Animation>(r).contact.pressure.pop_back(); },
     "one row per frame"},
    {"PressureLacksAVertex", [](Report& r) { first<Animation>(r).contact.pressure[0].pop_back(); },
     "ragged"},
    {"PressureOffTheMesh", [](Report& r) { first<Animation>(r).contact.vertices[0] = 100000; },
     "not there"},
    {"RaggedTable", [](Report& r) { first<Table>(r).rows[0].pop_back(); }, "one cell per column"},
    {"NumbersWithoutUnit", [](Report& r) { first<Table>(r).columns[1].unit.clear(); },
     "without a unit"},
    {"RaggedMatrix", [](Report& r) { first<Matrix>(r).rows[0].cells.pop_back(); },
     "one cell per column"},
    {"HatchingUnexplained", [](Report& r) { first<Matrix>(r).hatching.clear(); }, "hatching"},
    {"NoColourLimit", [](Report& r) { first<Matrix>(r).scale.limit = 0.0; }, "limit"},
    {"EmptyCell", [](Report& r) { first<Matrix>(r).rows[0].cells[0].text.clear(); }, "neither"},
    {"DeadLink", [](Report& r) { first<Matrix>(r).rows[0].cells[0].overlay = "ball Z/5"; },
     "ball Z/5"},
    {"DeadOverlays", [](Report& r) { first<Matrix>(r).overlays = "others"; }, "others"},
    {"ChosenMissing", [](Report& r) { first<Overlays>(r).chosen = "ball Z/5"; }, "shown first"},
    {"TwinOverlays", [](Report& r) { first<Overlays>(r).items[1].key = "ball P/5"; }, "twice"},
};

INSTANTIATE_TEST_SUITE_P(Each, RefusedReport, testing::ValuesIn(faults),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace rebound::report
