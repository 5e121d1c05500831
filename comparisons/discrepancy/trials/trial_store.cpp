#include "comparisons/discrepancy/trials/trial_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "comparisons/discrepancy/trials/table_fields.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr const char* warnings_name = "warnings";

/// Of what one protocol said of one trial.
std::string key_of(const std::string& protocol, const std::string& trial) {
  return member_key("trial\n" + protocol + "\n" + trial);
}

/// The columns of the table of trials as values with names.
MemberResult member_of(const TrialOutcome& outcome) {
  MemberResult member{.failure = outcome.failure};
  member.scalars.fill(std::numeric_limits<double>::quiet_NaN());
  const TrialRecord record{.truth = {}, .outcome = outcome};
  for (const TableField& field : outcome_fields()) {
    const std::string text = field.write(record);
    NamedValue& value = member.values.emplace_back(NamedValue{.name = field.name, .value = text});
    if (field.is_number) value.value = std::strtod(text.c_str(), nullptr);
  }
  member.values.push_back({.name = warnings_name, .value = joined(outcome.warnings, '\n')});
  return member;
}

TrialOutcome outcome_of(const MemberResult& member) {
  TrialRecord record;
  for (const TableField& field : outcome_fields()) {
    const NamedValue* value = value_named(member, field.name);
    if (!value) throw FieldError{};
    const double* number = std::get_if<double>(&value->value);
    field.read(number ? fmt::format("{}", *number) : std::get<std::string>(value->value), record);
  }
  TrialOutcome outcome = std::move(record.outcome);
  outcome.failure = member.failure;
  if (const NamedValue* warnings = value_named(member, warnings_name))
    if (const auto& text = std::get<std::string>(warnings->value); !text.empty())
      outcome.warnings = parts_of(text, '\n');
  return outcome;
}

bool is_store_of_trials(const std::filesystem::path& file) {
  return file.filename().string().starts_with("trials-") && file.extension() == ".sqlite";
}

std::filesystem::path file_of(const std::filesystem::path& folder, const std::string& protocol) {
  return folder / fmt::format("trials-{}.sqlite", protocol);
}

}  // namespace

TrialStore::TrialStore(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::vector<std::filesystem::path> files;
  std::error_code none;  // a folder that is not there holds no outcomes
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none))
    if (is_store_of_trials(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    ResultStore results(file);
    const Json protocol = Json::parse(results.program(), nullptr, false);
    const std::string digest = protocol.is_discarded() ? "" : protocol_digest(protocol);
    if (file != file_of(folder_, digest))
      throw Error(ExitCode::corrupt_store, "does not hold the protocol that its name says",
                  {.file = file.string(), .allowed = "trials-DIGEST.sqlite as `trials` made it"});
    protocols_[digest] = protocol;
    stores_.push_back({digest, std::move(results)});
  }
}

std::optional<TrialOutcome> TrialStore::find(const std::string& trial) {
  const std::lock_guard lock(guard_);
  for (OneProtocol& store : stores_) {
    const auto member = store.results.find(key_of(store.digest, trial));
    if (!member) continue;
    try {
      TrialOutcome outcome = outcome_of(*member);
      outcome.protocol = store.digest;  // which its key holds, too
      return outcome;
    } catch (const FieldError&) {
      throw Error(ExitCode::corrupt_store, "a member of the store is no outcome of a trial",
                  {.file = store.results.file().string()});
    }
  }
  return std::nullopt;
}

void TrialStore::write(const Json& protocol) {
  written_.emplace(file_of(folder_, protocol_digest(protocol)), ResultStore::Access::write,
                   protocol.dump());
}

void TrialStore::keep(const std::string& trial, const TrialOutcome& outcome) {
  const KeptMember member{.key = key_of(outcome.protocol, trial),
                          .factors = fmt::format("{{\"trial\":{}}}", outcome.trial),
                          .result = member_of(outcome)};
  const std::lock_guard lock(guard_);
  written_->keep({member});
}

}  // namespace rebound
