#include "comparisons/io/result_store/result_store.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "comparisons/io/result_store/packed_trace.hpp"
#include "comparisons/io/result_store/sqlite.hpp"
#include "comparisons/io/result_store/store_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

void add_bits(std::string& bytes, double value) {
  const std::uint64_t bits =
      std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value);
  bytes.append(reinterpret_cast<const char*>(&bits), sizeof bits);
}

/// CRC-32 over key and bits of a row: a changed bit of a value is seen.
std::int64_t checksum(const std::string& key, const MemberResult& result,
                      const std::string& trace) {
  std::string bytes = key + "\n" + result.failure + "\n";
  for (const double value : result.scalars) add_bits(bytes, value);
  for (const auto& [name, value] : result.values) {
    bytes += "\n" + name + "=";
    if (const double* number = std::get_if<double>(&value))
      add_bits(bytes, *number);
    else
      bytes += std::get<std::string>(value);
  }
  bytes += trace;
  return static_cast<std::int64_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void keep_values(Statement& insert, const KeptMember& member) {
  std::int64_t place = 0;
  for (const auto& [name, value] : member.result.values) {
    const auto* text = std::get_if<std::string>(&value);
    insert.bind(1, member.key);
    insert.bind(2, place++);
    insert.bind(3, name);
    if (text) {
      insert.clear(4);
      insert.bind(5, *text);
    } else {
      insert.bind(4, std::get<double>(value));
      insert.clear(5);
    }
    insert.step();
    insert.reset();
  }
}

std::filesystem::path checked(const std::filesystem::path& file, ResultStore::Access access,
                              const std::string& program) {
  if (access == ResultStore::Access::write && !std::filesystem::exists(file))
    make_store_file(file, program);
  check_store_file(file);
  return file;
}

}  // namespace

struct ResultStore::Connection {
  /// `wanted`: nothing, where any program will do.
  Connection(const std::filesystem::path& file, Access access,
             const std::optional<std::string>& wanted)
      : database(checked(file, access, wanted.value_or("")),
                 access == Access::write ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY) {
    Statement check(database, "PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok")
      refuse_store(file, "the store is damaged: " + check.text(0));
    Statement about(database, "SELECT value FROM about WHERE name = 'program'");
    program = about.step() ? about.text(0) : "";
    if (wanted && program != *wanted)
      refuse_store(
          file, fmt::format("the store was written by another version, {}", program),
          fmt::format("{}; run with another --out, or read it with the program of its results",
                      *wanted));
    // Keys are random: a commit changes as many pages as it has members. In a log of up to 64 MB
    // most of them are changed again before they are copied to the file.
    if (access == Access::write)
      database.execute("PRAGMA synchronous=NORMAL; PRAGMA wal_autocheckpoint=16000");
    select.emplace(database, ("SELECT failure, checksum, named, trace" + scalar_columns() +
                              " FROM member WHERE key = ?")
                                 .c_str());
    select_values.emplace(
        database, "SELECT name, number, text FROM named_value WHERE key = ? ORDER BY place");
  }

  void prepare_to_keep() {
    if (insert) return;
    std::string places = "?";
    for (std::size_t i = 0; i < member_scalars.size() + 5; ++i) places += ", ?";
    insert.emplace(database, ("INSERT OR IGNORE INTO member (key" + scalar_columns() +
                              ", failure, factors, named, trace, checksum) VALUES (" + places + ")")
                                 .c_str());
    insert_value.emplace(database, "INSERT OR IGNORE INTO named_value VALUES (?, ?, ?, ?, ?)");
  }

  void find_values(const std::string& key, std::vector<NamedValue>& values) {
    Statement& rows = *select_values;
    rows.reset();
    rows.bind(1, key);
    while (rows.step()) {
      NamedValue& value =
          values.emplace_back(NamedValue{.name = rows.text(0), .value = rows.number(1)});
      if (rows.has(2)) value.value = rows.text(2);
    }
    rows.reset();
  }

  Sqlite database;
  std::string program;
  std::optional<Statement> select, select_values;
  std::optional<Statement> insert, insert_value;  ///< once there is something to keep
};

ResultStore::ResultStore(const std::filesystem::path& file, Access access,
                         const std::string& program)
    : connection_(std::make_unique<Connection>(file, access, program)) {}
ResultStore::ResultStore(const std::filesystem::path& file)
    : connection_(std::make_unique<Connection>(file, Access::read, std::nullopt)) {}
ResultStore::~ResultStore() = default;
ResultStore::ResultStore(ResultStore&&) noexcept = default;

const std::filesystem::path& ResultStore::file() const {
  return connection_->database.file();
}

const std::string& ResultStore::program() const {
  return connection_->program;
}

std::optional<MemberResult> ResultStore::find(const std::string& key) {
  Statement& select = *connection_->select;
  select.reset();
  select.bind(1, key);
  if (!select.step()) {
    select.reset();
    return std::nullopt;
  }
  MemberResult result{.failure = select.text(0)};
  for (std::size_t i = 0; i < member_scalars.size(); ++i)
    result.scalars[i] = select.number(static_cast<int>(i) + 4);
  if (select.whole(2) > 0) connection_->find_values(key, result.values);
  const std::string trace = select.bytes(3);
  const bool whole = select.whole(1) == checksum(key, result, trace);
  select.reset();
  if (!whole) refuse_store(file(), "a stored member is damaged: its checksum does not agree");
  if (!trace.empty()) result.trace = unpacked(trace);
  return result;
}

void ResultStore::find_each(const std::vector<std::string>& keys,
                            const std::function<void(std::size_t, MemberResult)>& found) {
  connection_->database.execute("BEGIN");
  try {
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (auto member = find(keys[i])) found(i, *std::move(member));
  } catch (...) {
    sqlite3_exec(connection_->database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
  connection_->database.execute("COMMIT");
}

void ResultStore::keep(const std::vector<KeptMember>& members) {
  if (members.empty()) return;
  Sqlite& database = connection_->database;
  connection_->prepare_to_keep();
  Statement& insert = *connection_->insert;
  // In the order of the table, neighbours go into one page one after the other.
  std::vector<const KeptMember*> sorted;
  sorted.reserve(members.size());
  for (const KeptMember& member : members) sorted.push_back(&member);
  std::sort(sorted.begin(), sorted.end(),
            [](const KeptMember* a, const KeptMember* b) { return a->key < b->key; });
  database.execute("BEGIN IMMEDIATE");
  try {
    for (const KeptMember* one : sorted) {
      const KeptMember& member = *one;
      int place = 1;
      insert.bind(place++, member.key);
      for (const double value : member.result.scalars) insert.bind(place++, value);
      insert.bind(place++, member.result.failure);
      insert.bind(place++, member.factors);
      insert.bind(place++, static_cast<std::int64_t>(member.result.values.size()));
      const std::string trace =
          member.result.trace.empty() ? std::string() : packed(member.result.trace);
      insert.bind_bytes(place++, trace);
      insert.bind(place, checksum(member.key, member.result, trace));
      insert.step();
      insert.reset();
      keep_values(*connection_->insert_value, member);
    }
    database.execute("COMMIT");
  } catch (...) {
    connection_->insert->reset();
    connection_->insert_value->reset();
    sqlite3_exec(database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

void ResultStore::keep_campaign(const std::string& digest, const CampaignText& kept) {
  Statement insert(connection_->database, "INSERT OR IGNORE INTO campaign VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, digest);
  const auto& [file, text, base_file, base_text] = kept;
  int place = 2;
  for (const std::string& part : {file, text, base_file, base_text}) insert.bind(place++, part);
  insert.step();
}

std::vector<CampaignText> ResultStore::campaigns() {
  Statement select(connection_->database,
                   "SELECT file, text, base_file, base_text FROM campaign ORDER BY sha256");
  std::vector<CampaignText> all;
  while (select.step())
    all.push_back({.file = select.text(0),
                   .text = select.text(1),
                   .base_file = select.text(2),
                   .base_text = select.text(3)});
  return all;
}

std::vector<std::filesystem::path> store_files(const std::filesystem::path& store) {
  if (std::filesystem::is_regular_file(store)) return {store};
  std::vector<std::filesystem::path> files;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(store, status))
    if (entry.path().extension() == ".sqlite") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw Error(ExitCode::input_output_failed, "there are no results of a campaign here",
                {.file = store.string()});
  return files;
}

}  // namespace rebound
