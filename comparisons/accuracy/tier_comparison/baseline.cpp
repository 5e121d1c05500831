#include "comparisons/accuracy/tier_comparison/baseline.hpp"

#include <cmath>
#include <system_error>

#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

double finite(const Json& json, const char* key) {
  const double value = json.at(key).get<double>();
  if (!std::isfinite(value)) throw Error(ExitCode::corrupt_store, "a number is not finite");
  return value;
}

TierRecord record_of(const Json& json) {
  const Json& discretisation = json.at("discretisation");
  TierRecord record{.tier = json.at("tier").get<std::string>(),
                    .speed = finite(json, "speed_m_s"),
                    .separation = json.at("separation_rule").get<std::string>(),
                    .input_sha256 = json.at("input_sha256").get<std::string>(),
                    .discretisation = {.scheme = discretisation.at("scheme").get<std::string>(),
                                       .cells = discretisation.at("cells").get<int>(),
                                       .vertices = discretisation.at("vertices").get<int>(),
                                       .smallest_step = finite(discretisation, "smallest_step_s")},
                    .scalars = {}};
  for (const std::string& key : compared_keys()) {
    const Json& scalar = json.at("scalars").at(key);
    record.scalars[key] = {.value = finite(scalar, "value"),
                           .rounding = finite(scalar, "rounding"),
                           .step = finite(scalar, "step"),
                           .numerical = finite(scalar, "numerical")};
  }
  return record;
}

}  // namespace

std::filesystem::path baseline_file(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + ".json");
}

Json to_json(const TierRecord& record) {
  Json scalars = Json::object();
  for (const auto& [key, scalar] : record.scalars)
    scalars[key] = {{"value", scalar.value},
                    {"rounding", scalar.rounding},
                    {"step", scalar.step},
                    {"numerical", scalar.numerical}};
  return {{"tier", record.tier},
          {"speed_m_s", record.speed},
          {"separation_rule", record.separation},
          {"input_sha256", record.input_sha256},
          {"discretisation",
           {{"scheme", record.discretisation.scheme},
            {"cells", record.discretisation.cells},
            {"vertices", record.discretisation.vertices},
            {"smallest_step_s", record.discretisation.smallest_step}}},
          {"scalars", scalars}};
}

void write_baseline(const std::filesystem::path& folder, const std::string& name,
                    const std::vector<TierRecord>& records) {
  Json list = Json::array();
  for (const TierRecord& record : records) list.push_back(to_json(record));
  write_file_atomically(baseline_file(folder, name),
                        dump({{"schema", 1}, {"case", name}, {"records", list}}));
}

std::vector<TierRecord> read_baseline(const std::filesystem::path& folder,
                                      const std::string& name) {
  const auto file = baseline_file(folder, name);
  std::error_code status;
  if (!std::filesystem::exists(file, status))
    throw Error(ExitCode::bad_input, "the case has no baseline; --record writes one",
                {.file = file.string(), .key = "case", .value = name, .allowed = {}});
  const auto corrupt = [&](const std::string& reason) {
    return Error(ExitCode::corrupt_store, "this is not a whole baseline: " + reason,
                 {.file = file.string(), .key = {}, .value = {}, .allowed = {}});
  };
  try {
    const Json json = Json::parse(read_text_file(file));
    if (json.at("schema").get<int>() != 1 || json.at("case").get<std::string>() != name)
      throw corrupt("it is of another case or version");
    std::vector<TierRecord> records;
    for (const Json& record : json.at("records")) records.push_back(record_of(record));
    return records;
  } catch (const nlohmann::json::exception& error) {
    throw corrupt(error.what());
  }
}

}  // namespace rebound
