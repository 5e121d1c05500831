#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/accuracy/tier_comparison/compare_file.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "comparisons/evaluation/atlas/atlas_text.hpp"
#include "comparisons/evaluation/benchmark/benchmark_file.hpp"
#include "comparisons/evaluation/convert/conversion_file.hpp"
#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/selection/selection_file.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/dataset/published_values.hpp"
#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/schema_writer.hpp"
#include "comparisons/studies/campaign/campaign.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

struct Format {
  std::string name;
  Json (*schema)();
};

const std::vector<Format>& formats() {
  static const std::vector<Format> list{
      {"lumped", [] { return json_schema<LumpedImpactFile>("Impact file, lumped tier"); }},
      {"fem", [] { return json_schema<FemImpactFile>("Impact file, FE tier"); }},
      {"compress", [] { return json_schema<CompressionProblem>("Compression file"); }},
      {"calibrate", [] { return json_schema<CalibrationFile>("Calibration file"); }},
      {"benchmark", [] { return json_schema<BenchmarkFile>("Benchmark file"); }},
      {"atlas", [] { return json_schema<AtlasGrid>("Grid of the atlas"); }},
      {"select", [] { return json_schema<SelectionFile>("Selection file"); }},
      {"convert", [] { return json_schema<ConversionRequest>("Conversion file"); }},
      {"campaign", [] { return json_schema<CampaignFile>("Campaign file"); }},
      {"compare", [] { return json_schema<CompareFile>("Compare file"); }},
      {"synthesis", [] { return json_schema<SynthesisFile>("Synthesis file"); }},
      {"dataset", [] { return json_schema<Dataset>("Data set, dataset.toml"); }},
      {"published-values",
       [] { return json_schema<PublishedValues>("Published model values of a data set"); }},
  };
  return list;
}

ExitCode run_schema(const Session& session, const std::string& name) {
  for (const Format& format : formats()) {
    if (format.name != name) continue;
    const std::string text = dump(format.schema());
    if (session.out.empty()) {
      fmt::print("{}", text);
    } else {
      make_writable_folder(session.out);
      write_file_atomically(session.out / (name + ".schema.json"), text);
    }
  }
  return ExitCode::done;
}

}  // namespace

Action declare_schema(CLI::App& command) {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  const auto name = std::make_shared<std::string>();
  command.add_option("FORMAT", *name, "Which file")->required()->check(CLI::IsMember(names));
  command.footer(exit_code_help());
  return [name](const Session& session) { return run_schema(session, *name); };
}

}  // namespace rebound
