#include "comparisons/io/result_store/sqlite.hpp"

#include <limits>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr int longest_wait_ms = 60'000;

bool is_success(int status) {
  return status == SQLITE_OK || status == SQLITE_ROW || status == SQLITE_DONE;
}

}  // namespace

Sqlite::Sqlite(std::filesystem::path file, int flags)
    : file_(std::move(file)), handle_(nullptr, sqlite3_close_v2) {
  sqlite3* opened = nullptr;
  const int status = sqlite3_open_v2(file_.c_str(), &opened, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(opened);
  require(status);
  require(sqlite3_busy_timeout(opened, longest_wait_ms));
}

void Sqlite::require(int status) const {
  if (is_success(status)) return;
  const int kind = status & 0xff;
  const bool damaged = kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB || kind == SQLITE_ERROR;
  const std::string reason =
      handle_ ? sqlite3_errmsg(handle_.get()) : std::string(sqlite3_errstr(status));
  throw Error(damaged ? ExitCode::corrupt_store : ExitCode::input_output_failed,
              (damaged ? "the store is damaged: " : "the store cannot be used: ") + reason,
              {.file = file_.string()});
}

void Sqlite::execute(const char* sql) {
  require(sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr));
}

Statement::Statement(const Sqlite& database, const char* sql)
    : database_(database), handle_(nullptr, sqlite3_finalize) {
  sqlite3_stmt* made = nullptr;
  const int status = sqlite3_prepare_v2(database.handle(), sql, -1, &made, nullptr);
  handle_.reset(made);
  database.require(status);
}

void Statement::bind(int place, double value) {
  database_.require(sqlite3_bind_double(handle_.get(), place, value));
}

void Statement::bind(int place, std::int64_t value) {
  database_.require(sqlite3_bind_int64(handle_.get(), place, value));
}

void Statement::bind(int place, const std::string& text) {
  database_.require(sqlite3_bind_text(handle_.get(), place, text.data(),
                                      static_cast<int>(text.size()), SQLITE_TRANSIENT));
}

void Statement::bind_bytes(int place, const std::string& bytes) {
  if (bytes.empty()) return clear(place);
  database_.require(
      sqlite3_bind_blob64(handle_.get(), place, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
}

void Statement::clear(int place) {
  database_.require(sqlite3_bind_null(handle_.get(), place));
}

bool Statement::step() {
  const int status = sqlite3_step(handle_.get());
  database_.require(status);
  return status == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(handle_.get());
}

double Statement::number(int column) const {
  if (sqlite3_column_type(handle_.get(), column) == SQLITE_NULL)
    return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(handle_.get(), column);
}

std::string Statement::bytes(int column) const {
  const void* bytes = sqlite3_column_blob(handle_.get(), column);
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return bytes ? std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size))
               : std::string();
}

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(handle_.get(), column);
  return text ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace rebound
