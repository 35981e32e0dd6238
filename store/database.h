/// One SQLite connection and its prepared statements. Used from one thread.
#pragma once
#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "vocab/result.h"

namespace regolab {

enum class Access { kWrite, kRead };

/// What SQLite says, as the ladder's third rung: full -> kResourceExhausted, busy -> kUnavailable, broken -> kDataLoss.
Error sqlite_error(sqlite3* db, int code, std::string_view doing);

class Statement {
 public:
  Statement(sqlite3* db, sqlite3_stmt* statement) : db_(db), statement_(statement) {}
  ~Statement() {
    if (statement_) sqlite3_reset(statement_), sqlite3_clear_bindings(statement_);
  }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(std::int64_t value) { return check(sqlite3_bind_int64(statement_, ++bound_, value)); }
  Statement& bind(std::uint64_t value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(int value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(double value) { return check(sqlite3_bind_double(statement_, ++bound_, value)); }
  Statement& bind(std::string_view text) {
    return check(sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
  }
  Statement& bind_blob(std::string_view bytes) {
    return check(sqlite3_bind_blob64(statement_, ++bound_, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
  }
  Statement& bind_null() { return check(sqlite3_bind_null(statement_, ++bound_)); }
  Statement& bind_text_or_null(std::string_view text) { return text.empty() ? bind_null() : bind(text); }

  /// True: a row stands; false: done, or failed (see error()).
  bool step() {
    if (code_ == SQLITE_OK || code_ == SQLITE_ROW) code_ = sqlite3_step(statement_);
    return code_ == SQLITE_ROW;
  }
  Result<void> run(std::string_view doing) {
    while (step()) {
    }
    return end(doing);
  }
  /// After the last row: did it end well?
  Result<void> end(std::string_view doing) const {
    if (code_ == SQLITE_DONE) return {};
    return sqlite_error(db_, code_, doing);
  }

  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_, column); }
  double real(int column) const { return sqlite3_column_double(statement_, column); }
  bool null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  std::string text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))) : std::string{};
  }

 private:
  Statement& check(int code) {
    if (code != SQLITE_OK && code_ == SQLITE_OK) code_ = code;
    return *this;
  }
  sqlite3* db_;
  sqlite3_stmt* statement_;
  int bound_ = 0;
  int code_ = SQLITE_OK;
};

class Database {
 public:
  /// The writer creates the file (and calls set_up_writer() once the file is known to be ours); a reader never writes nor
  /// checkpoints.
  static Result<Database> open(const std::string& path, Access access);
  Result<void> set_up_writer();

  /// A cached statement, ready to be bound. REQUIRES: the last one of the same text is gone.
  Statement prepare(const char* sql);
  Result<void> run(const char* sql, std::string_view doing);
  std::int64_t changes() const { return sqlite3_changes64(db_.get()); }
  sqlite3* raw() const { return db_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3, Close> db_;
  std::unordered_map<const char*, std::unique_ptr<sqlite3_stmt, Finalize>> statements_;  ///< by the literal's address
};

/// BEGIN IMMEDIATE; rolls back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& db) : db_(db), begun_(db.run("BEGIN IMMEDIATE", "begin")) {}
  ~Transaction() {
    if (!done_ && sqlite3_get_autocommit(db_.raw()) == 0) (void)db_.run("ROLLBACK", "roll back").ok();
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  const Result<void>& begun() const { return begun_; }
  Result<void> commit() {
    auto committed = db_.run("COMMIT", "commit");
    done_ = committed.ok();
    return committed;
  }

 private:
  Database& db_;
  Result<void> begun_;
  bool done_ = false;
};

}  // namespace regolab
