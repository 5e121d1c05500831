#include "comparisons/io/result_store/store_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "comparisons/io/result_store/sqlite.hpp"
#include "comparisons/io/result_store/stored_member.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::uint32_t application = 0x52424E44;  // "RBND": a store of campaigns
constexpr std::uint32_t format_version = 3;
constexpr std::size_t header_size = 100;

std::uint32_t big_endian(const std::array<char, header_size>& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Zeros where the file is shorter. Read by SQLite's own hand: its locks are those of the process,
/// and another descriptor of the file would drop them when it is closed. Whoever looked into the
/// store then would take its log away, and what is kept after that would be lost.
std::array<char, header_size> first_bytes_of(const std::filesystem::path& file) {
  sqlite3_vfs* system = sqlite3_vfs_find(nullptr);
  std::vector<std::max_align_t> memory(1 + static_cast<std::size_t>(system->szOsFile) /
                                               sizeof(std::max_align_t));
  auto* const opened = reinterpret_cast<sqlite3_file*>(memory.data());
  const std::unique_ptr<const char, void (*)(sqlite3_filename)> name(
      sqlite3_create_filename(std::filesystem::absolute(file).c_str(), "", "", 0, nullptr),
      sqlite3_free_filename);
  if (system->xOpen(system, name.get(), opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_MAIN_DB,
                    nullptr) != SQLITE_OK)
    throw Error(ExitCode::input_output_failed, "the store cannot be opened",
                {.file = file.string()});
  std::array<char, header_size> bytes{};
  const int status = opened->pMethods->xRead(opened, bytes.data(), header_size, 0);
  opened->pMethods->xClose(opened);
  if (status != SQLITE_OK && status != SQLITE_IOERR_SHORT_READ)
    throw Error(ExitCode::input_output_failed, "the store cannot be read", {.file = file.string()});
  return bytes;
}

}  // namespace

std::string scalar_columns(const char* type) {
  std::string text;
  for (const char* name : member_scalars) text += fmt::format(", {}{}", name, type);
  return text;
}

void refuse_store(const std::filesystem::path& file, const std::string& why,
                  const std::string& allowed) {
  throw Error(ExitCode::corrupt_store, why, {.file = file.string(), .allowed = allowed});
}

void check_store_file(const std::filesystem::path& file) {
  const std::array<char, header_size> bytes = first_bytes_of(file);
  constexpr std::size_t version_place = 60, application_place = 68;  // of SQLite's file format
  if (!std::string_view(bytes.data(), header_size).starts_with("SQLite format 3"))
    refuse_store(file, "this is not a store of campaigns, or its beginning is damaged");
  if (big_endian(bytes, application_place) != application)
    refuse_store(file, "this SQLite file is not a store of campaigns");
  if (const auto version = big_endian(bytes, version_place); version != format_version)
    refuse_store(file, fmt::format("this store is of version {} of the format", version),
                 fmt::format("version {}", format_version));
}

void make_store_file(const std::filesystem::path& file, const std::string& program) {
  std::string part = file.string() + ".partial-XXXXXX";
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
                    "NULL, factors TEXT NOT NULL, named INTEGER NOT NULL, trace BLOB, checksum "
                    "INTEGER NOT NULL) "
                    "WITHOUT ROWID;"
                    "CREATE TABLE named_value (key TEXT, place INTEGER, name TEXT NOT NULL, "
                    "number REAL, text TEXT, PRIMARY KEY (key, place)) WITHOUT ROWID;",
                    application, format_version, scalar_columns(" REAL"))
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

}  // namespace rebound
