#include "store/migrate.h"

#include "schema.h"

namespace regolab {
namespace {

/// migrations[v] takes a file from version v to v + 1.
constexpr const char* kMigrations[] = {
    kSchema,
    "ALTER TABLE job ADD COLUMN most_damping_ratio REAL NOT NULL DEFAULT 0;",  // 0 = every dashpot as given, as it was
    // The penetration test. SQLite cannot change a CHECK, but a wider one asks nothing new of the rows that stand there: its text is
    // replaced, as sqlite.org/lang_altertable.html allows, and the new columns then tell other connections that the schema changed.
    "PRAGMA writable_schema=ON;"
    "UPDATE sqlite_schema SET sql = replace(sql, '''repose'', ''stress'')', '''repose'', ''stress'', ''penetration'')') "
    "WHERE type = 'table' AND name = 'job';"
    "PRAGMA writable_schema=RESET;"
    "ALTER TABLE job ADD COLUMN plate_width_m REAL NOT NULL DEFAULT 0;"
    "ALTER TABLE job ADD COLUMN plate_thickness_m REAL NOT NULL DEFAULT 0;",
    "CREATE TABLE model ("  // surrogates; `file` is their own JSON
    "id TEXT PRIMARY KEY, name TEXT NOT NULL, created_ms INTEGER NOT NULL, file TEXT NOT NULL) STRICT, WITHOUT ROWID;",
    "ALTER TABLE job ADD COLUMN effects TEXT NOT NULL DEFAULT '';",  // "cohesion=200;rolling_resistance=0.3"; '' = the base model, as it was
    "ALTER TABLE job ADD COLUMN isotropic_servo_steps REAL NOT NULL DEFAULT 50;",
    // Diagnoses. `id` is the digest of all that an answer is a function of; steps are kept as they are finished, so that one that was
    // killed goes on with them.
    "CREATE TABLE diagnosis (id TEXT PRIMARY KEY, case_name TEXT NOT NULL, created_ms INTEGER NOT NULL, ended_ms INTEGER,"
    " observations TEXT NOT NULL, bank TEXT NOT NULL, kernels TEXT NOT NULL, method TEXT NOT NULL,"  // SHA-256
    " options TEXT NOT NULL, held_out TEXT NOT NULL,"  // JSON; groups that the fit did not see: '' = it saw all
    " measurements BLOB NOT NULL, result TEXT NOT NULL, shrinkage TEXT NOT NULL) STRICT, WITHOUT ROWID;"  // regolab.v1.ImportRequest; JSON
    "CREATE INDEX diagnosis_observations ON diagnosis (observations);"
    "CREATE TABLE diagnosis_step (diagnosis TEXT NOT NULL REFERENCES diagnosis, name TEXT NOT NULL, done_ms INTEGER NOT NULL,"
    " result BLOB NOT NULL, PRIMARY KEY (diagnosis, name)) STRICT;",
};
static_assert(std::size(kMigrations) == kSchemaVersion);

Result<std::int64_t> number(Database& db, const char* pragma) {
  Statement statement = db.prepare(pragma);
  const std::int64_t value = statement.step() ? statement.integer(0) : -1;
  if (value < 0) return statement.end("read its header").error();
  return value;
}

}  // namespace

Result<void> check_header(Database& db) {
  const auto id = number(db, "PRAGMA application_id");
  if (!id.ok()) return id.error();
  const auto version = number(db, "PRAGMA user_version");
  if (!version.ok()) return version.error();
  const auto tables = number(db, "SELECT count(*) FROM sqlite_schema");
  if (!tables.ok()) return tables.error();
  if (*id != kApplicationId && (*id != 0 || *tables != 0)) {
    return Error{Code::kFailedPrecondition,
                 "the file is not a regolab database (application id " + std::to_string(*id) + "), give another file name"};
  }
  if (*version > kSchemaVersion) {
    return Error{Code::kFailedPrecondition, "the database is of a newer regolab (schema " + std::to_string(*version) +
                                                ", this program knows up to " + std::to_string(kSchemaVersion) +
                                                "), update regolab or give another file name"};
  }
  return {};
}

Result<void> migrate(Database& db) {
  Transaction transaction{db};
  if (!transaction.begun().ok()) return transaction.begun();
  const auto version = number(db, "PRAGMA user_version");
  if (!version.ok()) return version.error();
  if (*version == kSchemaVersion) return {};
  for (auto v = *version; v < kSchemaVersion; ++v) {
    if (auto step = db.run(kMigrations[v], "migrate"); !step.ok()) return step;
  }
  const std::string header =
      "PRAGMA application_id=" + std::to_string(kApplicationId) + "; PRAGMA user_version=" + std::to_string(kSchemaVersion);
  if (auto set = db.run(header.c_str(), "migrate"); !set.ok()) return set;
  return transaction.commit();
}

}  // namespace regolab
