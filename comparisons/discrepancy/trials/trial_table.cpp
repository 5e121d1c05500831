#include "comparisons/discrepancy/trials/trial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

#include "comparisons/discrepancy/trials/table_fields.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::string header_of(const std::vector<TableField>& fields) {
  Fields names;
  for (const TableField& one : fields) names.push_back(one.name);
  return joined(names, ',');
}

/// Of the table with this header: earlier ones end their truth with fewer columns.
/// Nothing: no table of trials.
std::optional<std::vector<TableField>> fields_of(const std::string& header) {
  std::vector<TableField> fields = table_fields();
  while (header != header_of(fields)) {
    const auto newest = std::find_if(fields.rbegin(), fields.rend(),
                                     [](const TableField& one) { return one.may_be_absent; });
    if (newest == fields.rend()) return std::nullopt;
    fields.erase(std::next(newest).base());
  }
  return fields;
}

/// A text with a comma or a line end in it would shift all columns behind it.
std::string checked_text(const TableField& field, const TrialRecord& record) {
  std::string text = field.write(record);
  if (text.find_first_of(",\n\r") != std::string::npos)
    throw Error(ExitCode::corrupt_store, "a field of the table holds a comma or a line end",
                {.key = field.name, .value = text});
  return text;
}

constexpr std::string_view protocol_mark = "# protocol ";

void read_protocol_line(const std::string& line, const ErrorLocation& where,
                        TrialProtocols& protocols) {
  const std::string text = line.substr(protocol_mark.size());
  const auto space = text.find(' ');
  const Json json = Json::parse(text.substr(std::min(space, text.size())), nullptr, false);
  if (json.is_discarded() || protocol_digest(json) != text.substr(0, space))
    throw Error(ExitCode::corrupt_store, "is not the protocol of this digest", where);
  protocols[text.substr(0, space)] = json;
}

TrialRecord record_of(const std::string& line, const std::vector<TableField>& fields,
                      const ErrorLocation& where) {
  const Fields texts = parts_of(line, ',');
  if (texts.size() != fields.size())
    throw Error(ExitCode::corrupt_store,
                fmt::format("has {} fields instead of {}", texts.size(), fields.size()), where);
  TrialRecord record;
  for (std::size_t i = 0; i < fields.size(); ++i) try {
      fields[i].read(texts[i], record);
    } catch (const FieldError&) {
      ErrorLocation at = where;
      at.key = fields[i].name;
      at.value = texts[i];
      at.allowed = "a number, or as many parts as the trial has effects";
      throw Error(ExitCode::corrupt_store, "is not a field of a table of trials", at);
    }
  record.outcome.trial = record.truth.trial;
  return record;
}

}  // namespace

std::string table_csv(const TrialCollection& trials) {
  const std::vector<TableField> fields = table_fields();
  std::string text;
  for (const auto& [digest, protocol] : trials.protocols)
    text += fmt::format("{}{} {}\n", protocol_mark, digest, protocol.dump());
  text += header_of(fields) + "\n";
  for (const TrialRecord& record : trials.records) {
    Fields row;
    for (const TableField& one : fields) row.push_back(checked_text(one, record));
    text += joined(row, ',') + "\n";
  }
  return text;
}

TrialCollection read_trial_table(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(ExitCode::input_output_failed, "cannot be read", {.file = file.string()});
  return trial_table_of({std::istreambuf_iterator<char>(in), {}}, file.string());
}

TrialCollection read_trial_tables(const std::vector<std::string>& files, bool mixed) {
  if (files.size() == 1) return read_trial_table(files.front());
  TrialCollection all;
  std::map<std::tuple<std::string, std::uint64_t, int>, std::string> seen;
  for (const std::string& file : files) {
    TrialCollection one = read_trial_table(file);
    all.protocols.merge(one.protocols);
    for (TrialRecord& record : one.records) {
      const TrialTruth& truth = record.truth;
      const auto [other, is_new] = seen.try_emplace({truth.set, truth.seed, truth.trial}, file);
      if (!is_new)
        throw Error(ExitCode::bad_input,
                    fmt::format("trial {} of seed {} stands in {}, too", truth.trial, truth.seed,
                                other->second),
                    {.file = file, .key = "--from-table", .allowed = "tables of other trials"});
      all.records.push_back(std::move(record));
    }
  }
  if (!mixed) refuse_several(all.protocols, files.front());
  return all;
}

TrialCollection trial_table_of(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  std::vector<TableField> fields;
  TrialCollection trials;
  ErrorLocation where{.file = name};
  bool has_header = false;
  for (std::string line; std::getline(in, line);) {
    ++where.line;
    if (line.starts_with(protocol_mark)) {
      read_protocol_line(line, where, trials.protocols);
    } else if (!has_header) {
      const auto own = fields_of(line);
      if (!own) {
        where.allowed = header_of(table_fields());
        throw Error(ExitCode::corrupt_store, "is not the header of a table of trials", where);
      }
      fields = *own;
      has_header = true;
    } else {
      trials.records.push_back(record_of(line, fields, where));
      if (!trials.protocols.contains(trials.records.back().outcome.protocol))
        throw Error(ExitCode::corrupt_store, "names a protocol that does not stand above", where);
    }
  }
  if (trials.records.empty())
    throw Error(ExitCode::corrupt_store, "holds no trials", {.file = name});
  return trials;
}

}  // namespace rebound
