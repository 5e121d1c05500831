#include "comparisons/evaluation/benchmark/benchmark_file.hpp"

#include "comparisons/io/toml/describe_impact.hpp"

namespace rebound {

void describe(Visitor& visit, BenchmarkRow& row) {
  visit.text({.name = "label", .sentence = "Name of the row in the matrix."}, row.label);
  visit.text({.name = "file",
              .sentence = "Lumped impact file whose [model] is scored as it stands; without it the "
                          "law below is calibrated to the references first.",
              .presence = Presence::optional},
             row.file);
  visit.where(!visit.refused("file") && row.file.empty(),
              [&](Visitor& inner) { describe_law_request(inner, row.request); });
}

void describe(Visitor& visit, BenchmarkFile& file) {
  describe_schema(visit);
  visit.list({.name = "law", .sentence = "A row of the matrix; repeat for more."}, file.rows);
  visit.list({.name = "reference", .sentence = "A folder of columns; repeat for more."},
             file.references);
}

}  // namespace rebound
