#include "store/database.h"

namespace regolab {

Error sqlite_error(sqlite3* db, int code, std::string_view doing) {
  const int extended = db ? sqlite3_extended_errcode(db) : code;
  const std::string text = "the database did not " + std::string(doing) + " (" +
                           (db ? sqlite3_errmsg(db) : sqlite3_errstr(code)) + ", SQLite code " + std::to_string(extended) +
                           ")";
  // The wal-index file could not grow: also a full disk.
  if (code == SQLITE_FULL || extended == SQLITE_IOERR_SHMSIZE)
    return {Code::kResourceExhausted, text + ", free some disk space"};
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
    return {Code::kUnavailable, text + ", close other programs that write to this file"};
  }
  if (code == SQLITE_CONSTRAINT) return {Code::kAborted, text};
  if (code == SQLITE_NOTADB) return {Code::kFailedPrecondition, text + ", give a regolab database or a new file name"};
  if (code == SQLITE_CANTOPEN || code == SQLITE_READONLY || code == SQLITE_PERM) {
    return {Code::kFailedPrecondition, text + ", check that the folder exists and may be written"};
  }
  return {Code::kDataLoss, text + ", check the disk and restore a copy if the file is damaged"};
}

Result<Database> Database::open(const std::string& path, Access access) {
  Database database;
  sqlite3* raw = nullptr;
  const int flags = access == Access::kWrite ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
  const int code = sqlite3_open_v2(path.c_str(), &raw, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  database.db_.reset(raw);
  if (code != SQLITE_OK) return sqlite_error(raw, code, "open " + path);
  sqlite3_extended_result_codes(raw, 0);
  sqlite3_busy_timeout(raw, 5000);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, access == Access::kRead ? 1 : 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (access == Access::kRead) {
    if (auto set = database.run("PRAGMA query_only=ON", "open " + path); !set.ok()) return set.error();
  }
  return database;
}

Result<void> Database::set_up_writer() {
  // Explicit checkpoints on the writing connection only: two connections that write and checkpoint can lose pages in
  // SQLite before 3.51.3.
  return run(
      "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA foreign_keys=ON; PRAGMA wal_autocheckpoint=0; "
      "PRAGMA journal_size_limit=67108864; PRAGMA cache_size=-32000",
      "switch to write-ahead logging");
}

Statement Database::prepare(const char* sql) {
  auto& held = statements_[sql];
  if (!held) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v3(db_.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
    held.reset(statement);  // a null statement answers SQLITE_MISUSE to everything
  }
  return {db_.get(), held.get()};
}

Result<void> Database::run(const char* sql, std::string_view doing) {
  const int code = sqlite3_exec(db_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) return sqlite_error(db_.get(), code, doing);
  return {};
}

}  // namespace regolab
