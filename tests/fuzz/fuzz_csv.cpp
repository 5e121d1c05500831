// Tables of a recorder or a spreadsheet: preview, wanted columns, and the window of a long record.
#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace rebound;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::as_file(data, size, ".csv");
  const std::vector<WantedColumn> wanted = {
      {.heading = "time", .accepted = {dimension::time}, .increases = true, .unit = "ms"},
      {.heading = "force", .accepted = {dimension::force, dimension::acceleration}},
      {.heading = "deflection", .accepted = {dimension::length}, .is_optional = true}};
  fuzz::refused_or_read([&] { preview_table(file); });
  fuzz::refused_or_read([&] { read_laboratory_table(file, wanted); });
  return fuzz::refused_or_read([&] {
    const KeptRows kept{.column = 1, .before = 3, .after = 2};
    const LaboratoryTable table = read_laboratory_table(file, wanted, kept);
    if (table.lines.empty() || table.lines.size() > 6 ||
        table.lines.size() != table.columns[1].numbers.size())
      std::abort();
  });
}
