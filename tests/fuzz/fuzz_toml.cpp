// Every kind of TOML file: impacts of both tiers, conversions, data sets.
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace rebound;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  return fuzz::refused_or_read([&] {
    const Document document = Document::parse(text, "fuzz.toml");
    fuzz::refused_or_read([&] { read_lumped_impact(document); });
    fuzz::refused_or_read([&] { read_fem_impact(document); });
    fuzz::refused_or_read([&] {
      Dataset dataset;
      read_document(document, dataset);
    });
  });
}
