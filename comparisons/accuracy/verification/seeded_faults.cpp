#include "comparisons/accuracy/verification/seeded_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/text.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Outcome = SeededFault::Outcome;

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == separator)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

/// "file:digest" parted by spaces: is each file still that? Not asked without sources.
bool unchanged(const std::string& recorded, const std::filesystem::path& sources) {
  if (sources.empty()) return true;
  for (const std::string& one : split(recorded, ' ')) {
    const auto colon = one.rfind(':');
    if (colon == std::string::npos) return false;
    if (digest_of_source(sources / one.substr(0, colon)) != one.substr(colon + 1)) return false;
  }
  return true;
}

/// Outcomes by the digest of the line they were run for.
std::map<std::string, SeededFault> read_results(const std::filesystem::path& file,
                                                const std::filesystem::path& sources) {
  std::map<std::string, SeededFault> results;
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    const auto fields = split(line, '\t');
    const bool known = (fields.size() == 6 || fields.size() == 7) &&
                       (fields[2] == "caught" || fields[2] == "survived");
    if (!known)
      throw Error(ExitCode::corrupt_store,
                  "not a recorded outcome: bash tests/mutations/run writes them",
                  {.file = file.string(), .line = number});
    Outcome outcome = fields[2] == "caught" ? Outcome::caught : Outcome::survived;
    if (fields.size() < 7 || !unchanged(fields[6], sources)) outcome = Outcome::stale;
    results[fields[1]] = {.name = fields[0],
                          .file = {},
                          .outcome = outcome,
                          .caught_by = fields[3],
                          .version = fields[4],
                          .date = fields[5]};
  }
  return results;
}

const char* word(Outcome outcome) {
  switch (outcome) {
    case Outcome::not_recorded: return "not recorded";
    case Outcome::caught: return "caught";
    case Outcome::survived: return "survived";
    case Outcome::stale: return "stale";
  }
  return "";
}

double count(const std::vector<SeededFault>& faults, Outcome outcome) {
  return static_cast<double>(
      std::count_if(faults.begin(), faults.end(),
                    [&](const SeededFault& fault) { return fault.outcome == outcome; }));
}

/// "v1, v2 (2026-01-01 to 2026-02-01)".
std::string recorded_on(const std::vector<SeededFault>& faults) {
  std::set<std::string> versions, dates;
  for (const SeededFault& fault : faults) {
    if (fault.outcome == Outcome::not_recorded) continue;
    versions.insert(fault.version);
    dates.insert(fault.date);
  }
  if (dates.empty()) return "no version";
  return fmt::format("{} ({}{})", fmt::join(versions, ", "), *dates.begin(),
                     dates.size() > 1 ? " to " + *dates.rbegin() : "");
}

}  // namespace

std::string digest_of_source(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return "";
  std::string text;
  for (std::string line; std::getline(in, line);)
    for (const char c : line.substr(0, line.find("//")))
      if (!std::isspace(static_cast<unsigned char>(c))) text += c;
  return sha256(text).substr(0, 16);
}

std::vector<SeededFault> read_seeded_faults(const std::filesystem::path& folder,
                                            const std::filesystem::path& sources) {
  if (!std::filesystem::exists(folder / "results.tsv")) return {};
  const auto results = read_results(folder / "results.tsv", sources);
  std::ifstream list(folder / "faults.txt");
  if (!list)
    throw Error(ExitCode::input_output_failed, "cannot be read",
                {.file = (folder / "faults.txt").string()});
  std::vector<SeededFault> faults;
  for (std::string line; std::getline(list, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto fields = split(line, '|');
    const auto found = results.find(sha256(line).substr(0, 16));
    SeededFault fault = found == results.end() ? SeededFault{} : found->second;
    fault.name = std::string(trimmed(fields[0]));
    fault.file = fields.size() > 1 ? std::string(trimmed(fields[1])) : "";
    faults.push_back(std::move(fault));
  }
  return faults;
}

VerificationTable rows_of(const std::vector<SeededFault>& faults) {
  if (faults.empty()) return {};
  const std::string source = "tests/mutations, recorded on " + recorded_on(faults);
  const double all = static_cast<double>(faults.size());
  const auto none = [&](const char* what, double result) {
    return VerificationRow{.case_id = "faults",
                           .quantity = what,
                           .unit = "",
                           .target = 0.0,
                           .result = result,
                           .tolerance = 0.0,
                           .scale = ToleranceScale::upper_bound,
                           .source = source};
  };
  return {none("seeded faults that survived the tests, recorded", count(faults, Outcome::survived)),
          none("seeded faults without a recorded outcome", count(faults, Outcome::not_recorded)),
          none("seeded faults whose recorded outcome is stale", count(faults, Outcome::stale)),
          none("share of seeded faults not caught, recorded, less 5 %",
               std::max(0.0, 0.95 - count(faults, Outcome::caught) / all))};
}

std::string to_text(const std::vector<SeededFault>& faults) {
  if (faults.empty())
    return "Seeded faults: no run is recorded (bash tests/mutations/run records one)\n";
  std::string text =
      fmt::format("Seeded faults, as recorded on {}; not run now:\n", recorded_on(faults));
  for (const SeededFault& fault : faults)
    text += fmt::format("  {:<13}{:<44}{}\n", word(fault.outcome), fault.name, fault.caught_by);
  return text;
}

Json to_json(const std::vector<SeededFault>& faults) {
  Json json = Json::array();
  for (const SeededFault& fault : faults)
    json.push_back({{"name", fault.name},
                    {"file", fault.file},
                    {"outcome", word(fault.outcome)},
                    {"caught_by", fault.caught_by},
                    {"version", fault.version},
                    {"date", fault.date}});
  return json;
}

report::Table table_of(const std::vector<SeededFault>& faults) {
  using Verdict = report::TableCell::Verdict;
  report::Table table{
      .title = "Seeded faults",
      .caption = fmt::format(
          "Would the tests notice a wrong formula? One fault at a time was put into the "
          "sources and the tests named beside it were run. As recorded on {}; not run now.",
          recorded_on(faults)),
      .columns = {{"fault"}, {"file"}, {"outcome"}, {"caught by"}, {"version"}, {"date"}},
      .rows = {}};
  for (const SeededFault& fault : faults) {
    const Verdict verdict = fault.outcome == Outcome::caught     ? Verdict::good
                            : fault.outcome == Outcome::survived ? Verdict::bad
                                                                 : Verdict::doubtful;
    table.rows.push_back({report::text_cell(fault.name), report::text_cell(fault.file),
                          report::text_cell(word(fault.outcome), verdict),
                          report::text_cell(fault.caught_by), report::text_cell(fault.version),
                          report::text_cell(fault.date)});
  }
  return table;
}

}  // namespace rebound
