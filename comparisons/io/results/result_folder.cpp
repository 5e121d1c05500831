#include "comparisons/io/results/result_folder.hpp"

#include <system_error>

#include "comparisons/io/results/trace_csv.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

constexpr const char* all_files[] = {"result.json",          "trace.csv", "incomplete.json",
                                     "trace-incomplete.csv", "curve.csv", "curve-incomplete.csv",
                                     "effective.toml"};

struct Names {
  const char* json;
  const char* trace;
};

void write_files(const ResultFolder& target, const Names& names, Json json,
                 const std::string& trace) {
  make_writable_folder(target.folder);
  // Files of an earlier run must not stand beside those of this one.
  for (const char* name : all_files) {
    std::error_code status;
    std::filesystem::remove(target.folder / name, status);
  }
  json["provenance"] = to_json(target.provenance);
  write_file_atomically(target.folder / "effective.toml", target.effective_toml);
  write_file_atomically(target.folder / names.trace, trace);
  write_file_atomically(target.folder / names.json, dump(json));
}

}  // namespace

void write_result(const ResultFolder& target, const LumpedResult& result) {
  write_files(target, {"result.json", "trace.csv"}, to_json(result), trace_csv(result.trace));
}

void write_result(const ResultFolder& target, const FemResult& result) {
  const std::string trace = trace_csv(result.trace, result.energies);
  if (result.incomplete_because.empty()) {
    Json json = to_json(result);
    if (!target.further_keys.is_null()) json.update(target.further_keys);
    write_files(target, {"result.json", "trace.csv"}, json, trace);
    return;
  }
  const Json json = {{"schema", 1},
                     {"complete", false},
                     {"incomplete_because", result.incomplete_because},
                     {"cells", result.cells},
                     {"steps", result.steps},
                     {"wall_s", result.wall_seconds}};
  write_files(target, {"incomplete.json", "trace-incomplete.csv"}, json, trace);
}

void write_result(const ResultFolder& target, const CompressionResult& result) {
  const std::string curve = curve_csv(result.curve);
  if (result.incomplete_because.empty()) {
    write_files(target, {"result.json", "curve.csv"}, to_json(result), curve);
    return;
  }
  const Json json = {{"schema", 1},
                     {"complete", false},
                     {"incomplete_because", result.incomplete_because},
                     {"cells", result.cells},
                     {"wall_s", result.wall_seconds}};
  write_files(target, {"incomplete.json", "curve-incomplete.csv"}, json, curve);
}

}  // namespace rebound
