#include "comparisons/io/report/write_report.hpp"

#include "comparisons/io/report/check.hpp"
#include "comparisons/io/report/json.hpp"
#include "comparisons/io/report/page.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound::report {

void write_report(const Report& report, const std::filesystem::path& file) {
  check_report(report);
  if (file.has_parent_path()) make_writable_folder(file.parent_path());
  write_file_atomically(file, page_html(report.title, report_json(report)));
}

}  // namespace rebound::report
