#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

#include "comparisons/accuracy/tier_comparison/compare_file.hpp"
#include "comparisons/app/commands.hpp"
#include "comparisons/app/output_schemas.hpp"
#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "comparisons/evaluation/atlas/atlas_text.hpp"
#include "comparisons/evaluation/benchmark/benchmark_file.hpp"
#include "comparisons/evaluation/convert/conversion_file.hpp"
#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/inference/selection/selection_file.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/dataset/published_values.hpp"
#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/schema_writer.hpp"
#include "comparisons/studies/campaign/campaign.hpp"
#include "comparisons/studies/campaign/diagnosis_base.hpp"
#include "comparisons/studies/study/study_file.hpp"
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
      {"calibrate-material",
       [] { return json_schema<MaterialCalibrationFile>("Calibration file of a material"); }},
      {"benchmark", [] { return json_schema<BenchmarkFile>("Benchmark file"); }},
      {"atlas", [] { return json_schema<AtlasGrid>("Grid of the atlas"); }},
      {"select", [] { return json_schema<SelectionFile>("Selection file"); }},
      {"convert", [] { return json_schema<ConversionRequest>("Conversion file"); }},
      {"campaign", [] { return json_schema<CampaignFile>("Campaign file"); }},
      {"study", [] { return json_schema<StudyFile>("Study file"); }},
      {"diagnosis", [] { return json_schema<DiagnosisFile>("Diagnosis that a campaign varies"); }},
      {"compare", [] { return json_schema<CompareFile>("Compare file"); }},
      {"synthesis", [] { return json_schema<SynthesisFile>("Synthesis file"); }},
      {"dataset", [] { return json_schema<Dataset>("Data set, dataset.toml"); }},
      {"published-values",
       [] { return json_schema<PublishedValues>("Published model values of a data set"); }},
  };
  return list;
}

struct Asked {
  std::string name;
  bool output = false;
};

Json schema_of_file(const std::string& name) {
  std::vector<std::string> names;
  for (const Format& format : formats()) {
    if (format.name == name) return format.schema();
    names.push_back(format.name);
  }
  throw Error(ExitCode::bad_input, "no file is of this format; --output has what it prints",
              {.file = {},
               .key = "FORMAT",
               .value = name,
               .allowed = fmt::format("{}", fmt::join(names, ", "))});
}

ExitCode run_schema(const Session& session, const Asked& asked) {
  const std::string text =
      dump(asked.output ? output_schema(asked.name) : schema_of_file(asked.name));
  if (session.out.empty()) {
    fmt::print("{}", text);
  } else {
    make_writable_folder(session.out);
    const std::string kind = asked.output ? ".output.schema.json" : ".schema.json";
    write_file_atomically(session.out / (asked.name + kind), text);
  }
  return ExitCode::done;
}

}  // namespace

Action declare_schema(CLI::App& command) {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  for (const Command& other : commands())
    if (std::find(names.begin(), names.end(), other.name) == names.end())
      names.push_back(other.name);
  names.emplace_back("error");
  const auto asked = std::make_shared<Asked>();
  command.add_option("FORMAT", asked->name, "Which file; of --output: which command")
      ->required()
      ->check(CLI::IsMember(names));
  command.add_flag("--output", asked->output,
                   "Of what the command prints under --json; error: where it fails");
  command.footer(exit_code_help());
  return [asked](const Session& session) { return run_schema(session, *asked); };
}

}  // namespace rebound
