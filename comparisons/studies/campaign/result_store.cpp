#include "comparisons/studies/campaign/result_store.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/studies/campaign/sqlite.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::uint32_t application = 0x52424E44;  // "RBND": a store of campaigns
constexpr std::uint32_t format_version = 1;
constexpr std::size_t header_size = 100;

std::string columns(const char* type = "") {
  std::string text;
  for (const char* name : member_scalars) text += fmt::format(", {}{}", name, type);
  return text;
}

/// First digits of SHA-256 over key and bits of a row: a changed bit of a value is seen.
std::int64_t checksum(const std::string& key, const MemberResult& result) {
  std::string bytes = key + "\n" + result.failure + "\n";
  for (const double value : result.scalars) {
    const auto bits = std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value);
    bytes += fmt::format("{:x},", bits);
  }
  return static_cast<std::int64_t>(std::stoull(sha256(bytes).substr(0, 15), nullptr, 16));
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why,
                         const std::string& allowed = {}) {
  throw Error(ExitCode::corrupt_store, why, {.file = file.string(), .allowed = allowed});
}

std::uint32_t big_endian(const std::array<char, header_size>& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// What a file is, before SQLite opens it: opening may write to a file.
void check_header(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw Error(ExitCode::input_output_failed, "the store cannot be opened",
                {.file = file.string()});
  std::array<char, header_size> bytes{};
  in.read(bytes.data(), header_size);
  constexpr std::size_t version_place = 60, application_place = 68;  // of SQLite's file format
  if (in.gcount() != header_size ||
      !std::string_view(bytes.data(), header_size).starts_with("SQLite format 3"))
    refuse(file, "this is not a store of campaigns, or its beginning is damaged");
  if (big_endian(bytes, application_place) != application)
    refuse(file, "this SQLite file is not a store of campaigns");
  if (const auto version = big_endian(bytes, version_place); version != format_version)
    refuse(file, fmt::format("this store is of version {} of the format", version),
           fmt::format("version {}", format_version));
}

/// Under a name of its own, then linked to the final one: a store is there whole or not at all, and
/// of two that make it one wins.
void create(const std::filesystem::path& file, const std::string& program) {
  std::string part = file.string() + ".part-XXXXXX";
  const int placeholder = ::mkstemp(part.data());
  if (placeholder < 0)
    throw Error(ExitCode::input_output_failed,
                std::string("the store cannot be made: ") + std::strerror(errno),
                {.file = file.string()});
  constexpr mode_t readable_by_all = 0644;
  ::fchmod(placeholder, readable_by_all);
  ::close(placeholder);
  std::error_code ignored;
  try {
    Sqlite made(part, SQLITE_OPEN_READWRITE);
    made.execute(
        fmt::format("PRAGMA application_id={}; PRAGMA user_version={}; PRAGMA "
                    "journal_mode=WAL; BEGIN;"
                    "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL);"
                    "CREATE TABLE campaign (sha256 TEXT PRIMARY KEY, file TEXT, text TEXT, "
                    "base_file TEXT, base_text TEXT);"
                    "CREATE TABLE member (key TEXT PRIMARY KEY{}, failure TEXT NOT "
                    "NULL, factors TEXT NOT NULL, checksum INTEGER NOT NULL) WITHOUT ROWID;",
                    application, format_version, columns(" REAL"))
            .c_str());
    Statement about(made, "INSERT INTO about VALUES ('program', ?)");
    about.bind(1, program);
    about.step();
    about.reset();
    made.execute("COMMIT; PRAGMA wal_checkpoint(TRUNCATE)");
  } catch (...) {
    for (const char* end : {"", "-wal", "-shm", "-journal"})
      std::filesystem::remove(part + end, ignored);
    throw;
  }
  const int linked = ::link(part.c_str(), file.c_str());
  const int reason = errno;
  std::filesystem::remove(part, ignored);
  if (linked != 0 && reason != EEXIST)
    throw Error(ExitCode::input_output_failed,
                std::string("the store cannot be made: ") + std::strerror(reason),
                {.file = file.string()});
}

std::filesystem::path checked(const std::filesystem::path& file, ResultStore::Access access,
                              const std::string& program) {
  if (access == ResultStore::Access::write && !std::filesystem::exists(file)) create(file, program);
  check_header(file);
  return file;
}

}  // namespace

struct ResultStore::Connection {
  Connection(const std::filesystem::path& file, Access access, const std::string& program)
      : database(checked(file, access, program),
                 access == Access::write ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY) {
    Statement check(database, "PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok")
      refuse(file, "the store is damaged: " + check.text(0));
    Statement about(database, "SELECT value FROM about WHERE name = 'program'");
    const std::string found = about.step() ? about.text(0) : "";
    if (found != program)
      refuse(file, fmt::format("the store was written by another version, {}", found),
             fmt::format("{}; run with another --out, or read it with the program of its results",
                         program));
    if (access == Access::write) database.execute("PRAGMA synchronous=NORMAL");
    select.emplace(database,
                   ("SELECT failure, checksum" + columns() + " FROM member WHERE key = ?").c_str());
  }

  Sqlite database;
  std::optional<Statement> select;
};

ResultStore::ResultStore(const std::filesystem::path& file, Access access,
                         const std::string& program)
    : connection_(std::make_unique<Connection>(file, access, program)) {}
ResultStore::~ResultStore() = default;
ResultStore::ResultStore(ResultStore&&) noexcept = default;

const std::filesystem::path& ResultStore::file() const {
  return connection_->database.file();
}

std::optional<MemberResult> ResultStore::find(const std::string& key) {
  Statement& select = *connection_->select;
  select.reset();
  select.bind(1, key);
  if (!select.step()) {
    select.reset();
    return std::nullopt;
  }
  MemberResult result{.scalars = {}, .failure = select.text(0)};
  for (std::size_t i = 0; i < member_scalars.size(); ++i)
    result.scalars[i] = select.number(static_cast<int>(i) + 2);
  const bool whole = select.whole(1) == checksum(key, result);
  select.reset();
  if (!whole) refuse(file(), "a stored member is damaged: its checksum does not agree");
  return result;
}

void ResultStore::keep(const std::vector<KeptMember>& members) {
  if (members.empty()) return;
  Sqlite& database = connection_->database;
  database.execute("BEGIN IMMEDIATE");
  try {
    std::string places = "?";
    for (std::size_t i = 0; i < member_scalars.size() + 3; ++i) places += ", ?";
    Statement insert(database, ("INSERT OR IGNORE INTO member (key" + columns() +
                                ", failure, factors, checksum) VALUES (" + places + ")")
                                   .c_str());
    for (const KeptMember& member : members) {
      int place = 1;
      insert.bind(place++, member.key);
      for (const double value : member.result.scalars) insert.bind(place++, value);
      insert.bind(place++, member.result.failure);
      insert.bind(place++, member.factors);
      insert.bind(place, checksum(member.key, member.result));
      insert.step();
      insert.reset();
    }
    database.execute("COMMIT");
  } catch (...) {
    sqlite3_exec(database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

void ResultStore::keep_campaign(const Campaign& campaign) {
  Statement insert(connection_->database, "INSERT OR IGNORE INTO campaign VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, campaign.digest());
  const auto& [file, text, base_file, base_text] = campaign.text();
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
