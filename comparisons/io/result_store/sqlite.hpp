#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <string>

namespace rebound {

/// A connection to one SQLite file, and its errors as those of the suite.
class Sqlite {
 public:
  /// `flags` as of sqlite3_open_v2. Waits up to a minute for another writer.
  Sqlite(std::filesystem::path file, int flags);

  sqlite3* handle() const { return handle_.get(); }
  const std::filesystem::path& file() const { return file_; }

  void execute(const char* sql);
  /// Throws what `status` means, unless it is a success.
  void require(int status) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, int (*)(sqlite3*)> handle_;
};

/// A prepared statement, used again after reset().
class Statement {
 public:
  Statement(const Sqlite& database, const char* sql);

  void bind(int place, double value);  ///< NaN as NULL
  void bind(int place, std::int64_t value);
  void bind(int place, const std::string& text);
  void bind_bytes(int place, const std::string& bytes);  ///< none as NULL
  void clear(int place);                                 ///< NULL
  bool step();                                           ///< is there a row?
  void reset();

  bool has(int column) const { return sqlite3_column_type(handle_.get(), column) != SQLITE_NULL; }
  double number(int column) const;  ///< NULL as NaN
  std::int64_t whole(int column) const { return sqlite3_column_int64(handle_.get(), column); }
  std::string text(int column) const;
  std::string bytes(int column) const;  ///< NULL as none

 private:
  const Sqlite& database_;
  std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> handle_;
};

}  // namespace rebound
