#pragma once
// SQLite with its handles owned and its failures thrown: within the store alone, which returns them as
// sentences.

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fulcrum::session::sql {

struct Failure : std::runtime_error {
  Failure(int code_, const std::string& what) : std::runtime_error(what), code(code_) {}
  int code;  // of SQLite, extended
};

class Statement {
public:
  Statement(sqlite3* database, std::string_view text);

  // In their order, from the first on.
  Statement& bind(std::string_view text);
  Statement& bind(std::int64_t number);
  Statement& bind(double number);
  Statement& bind(const std::optional<double>& number);

  bool step();  // whether there is a row
  void run() {  // to its end, without rows
    while (step()) {
    }
  }
  // Again, with other values.
  void reset();

  std::string text(int column) const;
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  double number(int column) const { return sqlite3_column_double(statement_.get(), column); }
  bool is_null(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  void check(int code) const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
};

class Database {
public:
  // The file must be there.
  explicit Database(const std::filesystem::path& file);

  Statement prepare(std::string_view text) { return {handle_.get(), text}; }
  void run(const char* text);  // one statement or several
  std::int64_t integer(std::string_view query);

private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

// All of it or nothing: rolled back unless it is committed.
class Transaction {
public:
  // begin: "BEGIN" suffices where nothing is written, for one moment's view of all rows.
  explicit Transaction(Database& database, const char* begin = "BEGIN IMMEDIATE") : database_(database) {
    database_.run(begin);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

private:
  Database& database_;
  bool open_ = true;
};

}  // namespace fulcrum::session::sql
