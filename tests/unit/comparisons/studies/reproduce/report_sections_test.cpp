#include "comparisons/studies/reproduce/report_sections.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/report/check.hpp"
#include "tests/unit/comparisons/studies/reproduce/whole_reproduction.hpp"

namespace rebound {
namespace {

using testing::whole_reproduction;

TEST(ReportSectionsTest, TheReportPassesItsChecks) {
  EXPECT_NO_THROW(report::check_report(reproduction_report(whole_reproduction())));
}

TEST(ReportSectionsTest, TheFirstSectionIsTheOneAStudyShows) {
  const auto sections = report_sections(whole_reproduction());
  EXPECT_EQ(sections.front().title, "What the paper's numbers do not imply");
  std::size_t notices = 0;
  for (const report::Block& block : sections.front().blocks)
    notices += std::holds_alternative<report::Notice>(block) ? 1 : 0;
  EXPECT_EQ(notices, whole_reproduction().findings.size());
}

void expect_no_measured_line(const report::Figure& figure) {
  for (const report::Series& series : figure.series) {
    const bool line = series.style == report::Series::Style::line;
    EXPECT_TRUE(!line || series.origin == report::Origin::predicted) << figure.title;
  }
}

TEST(ReportSectionsTest, NoDrawnLineIsMeasured) {
  std::size_t figures = 0;
  for (const report::Section& section : report_sections(whole_reproduction()))
    for (const report::Block& block : section.blocks) {
      if (const auto* figure = std::get_if<report::Figure>(&block)) {
        expect_no_measured_line(*figure);
        ++figures;
      }
      if (const auto* overlays = std::get_if<report::Overlays>(&block)) {
        EXPECT_EQ(overlays->items.size(), 12u);
        for (const report::Overlay& overlay : overlays->items)
          for (const report::Figure& figure : overlay.figures) expect_no_measured_line(figure);
      }
    }
  EXPECT_EQ(figures, 3u);  // Fig. 5, Figs 6(a) and 6(b)
}

}  // namespace
}  // namespace rebound
