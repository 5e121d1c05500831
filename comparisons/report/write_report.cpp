#include "comparisons/report/write_report.hpp"

#include "comparisons/report/check.hpp"
#include "comparisons/report/json.hpp"
#include "comparisons/report/page.hpp"
#include "comparisons/results/atomic_file.hpp"

namespace rebound::report {

void write_report(const Report& report, const std::filesystem::path& file) {
  check_report(report);
  if (file.has_parent_path()) make_writable_folder(file.parent_path());
  write_file_atomically(file, page_html(report.title, report_json(report)));
}

}  // namespace rebound::report
