#include "store/store.h"

#include <algorithm>

#include "store/migrate.h"

namespace regolab {

Store::Store(LockFile lock, Database db, ArtifactFiles files)
    : lock_(std::move(lock)), db_(std::move(db)), files_(std::move(files)) {
  sqlite3_wal_hook(
      db_.raw(),
      [](void* self, sqlite3*, const char*, int pages) {
        static_cast<Store*>(self)->log_pages_ = pages;
        return SQLITE_OK;
      },
      this);
}

Result<std::unique_ptr<Store>> Store::open(const std::string& path) {
  auto lock = LockFile::take(path + ".lock");
  if (!lock.ok()) return lock.error();
  auto db = Database::open(path, Access::kWrite);
  if (!db.ok()) return db.error();
  if (auto ours = check_header(*db); !ours.ok()) return ours.error();
  if (auto set = db->set_up_writer(); !set.ok()) return set.error();
  if (auto migrated = migrate(*db); !migrated.ok()) return migrated.error();
  auto files = ArtifactFiles::open(path + ".d");
  if (!files.ok()) return files.error();
  return std::unique_ptr<Store>(new Store(std::move(*lock), std::move(*db), std::move(*files)));
}

void Store::rollback() {
  if (sqlite3_get_autocommit(db_.raw()) == 0) (void)db_.run("ROLLBACK", "roll back").ok();  // a lost file cannot roll back
}

Result<void> Store::checkpoint(bool empty_log) {
  int log = 0, moved = 0;
  sqlite3_busy_timeout(db_.raw(), 0);  // do not wait for readers
  const int mode = empty_log ? SQLITE_CHECKPOINT_TRUNCATE : SQLITE_CHECKPOINT_PASSIVE;
  const int code = sqlite3_wal_checkpoint_v2(db_.raw(), nullptr, mode, &log, &moved);
  sqlite3_busy_timeout(db_.raw(), 5000);
  if (code == SQLITE_BUSY) return {};  // a reader is in the way; next time
  if (code != SQLITE_OK) return sqlite_error(db_.raw(), code, "checkpoint");
  if (moved >= log) log_pages_ = 0;
  return {};
}

Result<void> Store::limit_pages(int pages) {
  return db_.run(("PRAGMA max_page_count=" + std::to_string(pages)).c_str(), "limit its size");
}

Result<void> Store::has_room() {
  Transaction transaction{db_};
  if (!transaction.begun().ok()) return transaction.begun();
  auto written = db_.run(
      "INSERT INTO counter VALUES ('room', 1) ON CONFLICT (name) DO UPDATE SET value = value + 1;"
      "CREATE TABLE room AS SELECT randomblob(65536) AS bytes; DROP TABLE room",
      "write a page");
  if (!written.ok()) return written;
  return transaction.commit();
}

Result<LeaseToken> Store::next_boot(std::int64_t unix_s) {
  Transaction transaction{db_};
  if (!transaction.begun().ok()) return transaction.begun().error();
  std::int64_t epoch = unix_s;
  {
    Statement read = db_.prepare("SELECT value FROM counter WHERE name = 'boot'");
    if (read.step()) epoch = std::max(epoch, read.integer(0) + 1);
  }
  auto written =
      db_.prepare("INSERT INTO counter VALUES ('boot', ?) ON CONFLICT (name) DO UPDATE SET value = excluded.value")
          .bind(epoch)
          .run("store the boot number");
  if (!written.ok()) return written.error();
  if (auto committed = transaction.commit(); !committed.ok()) return committed.error();
  return LeaseToken{static_cast<std::uint64_t>(epoch) << 28};
}

Result<void> Store::add_job(const JobRecord& record) {
  const auto& [identity, status] = record;
  const Micro& m = identity.spec.micro;
  const Numerics& n = identity.spec.numerics;
  Statement s = db_.prepare(
      "INSERT INTO job VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?, ?, ?, "
      "NULL, NULL, ?, ?, ?, ?, ?)");
  s.bind(static_cast<std::uint64_t>(identity.id)).bind(identity.key).bind(name_of(identity.spec.kind));
  if (identity.parent == JobId{})
    s.bind_null();
  else
    s.bind(static_cast<std::uint64_t>(identity.parent));
  s.bind(identity.spec.seed).bind(identity.spec.confining_stress);
  s.bind(m.friction_angle)
      .bind(m.normal_stiffness)
      .bind(m.normal_damping)
      .bind(m.tangential_stiffness)
      .bind(m.tangential_damping);
  s.bind(m.largest_diameter)
      .bind(static_cast<int>(m.kind))
      .bind(static_cast<int>(m.rotation))
      .bind(static_cast<int>(m.damping_unit));
  s.bind(m.grain_density).bind(m.gravity).bind(n.clusters).bind(n.box_length).bind(n.box_width);
  s.bind(n.settle_stiffness_number).bind(n.stress_stiffness_number).bind(n.mass_floor).bind(n.step_fraction);
  s.bind(n.inertial_number).bind(n.axial_strain);
  s.bind(name_of(status.state)).bind(static_cast<std::uint64_t>(status.token)).bind(status.worker).bind(status.attempts);
  s.bind(status.deaths).bind(status.deaths_anywhere).bind(status.death_steps).bind(status.detail);
  s.bind(n.most_damping_ratio).bind(identity.spec.plate.width).bind(identity.spec.plate.thickness);
  s.bind(effects_text(identity.spec.effects)).bind(n.isotropic_servo_steps);
  return s.run("store a job");
}

Result<void> Store::change_job(JobId id, const JobStatus& status) {
  return db_
      .prepare(
          "UPDATE job SET state = ?, lease_token = ?, worker = ?, attempts = ?, deaths = ?, deaths_anywhere = ?, "
          "death_steps = ?, "
          "detail = ?, bed = ?, checkpoint = ? WHERE id = ?")
      .bind(name_of(status.state))
      .bind(static_cast<std::uint64_t>(status.token))
      .bind(status.worker)
      .bind(status.attempts)
      .bind(status.deaths)
      .bind(status.deaths_anywhere)
      .bind(status.death_steps)
      .bind(status.detail)
      .bind_text_or_null(status.bed)
      .bind_text_or_null(status.checkpoint)
      .bind(static_cast<std::uint64_t>(id))
      .run("change a job");
}

Result<void> Store::link(const JobLink& link) {
  const auto experiment = static_cast<std::uint64_t>(link.experiment);
  return db_
      .prepare(
          "INSERT INTO experiment_job SELECT ?, 1 + coalesce((SELECT max(n) FROM experiment_job WHERE experiment = ?), 0), "
          "?, ?, "
          "?, ?")
      .bind(experiment)
      .bind(experiment)
      .bind(static_cast<std::uint64_t>(link.job))
      .bind(link.point)
      .bind(link.seed)
      .bind(link.reused ? 1 : 0)
      .run("link a job");
}

Result<void> Store::start_attempt(JobId job, LeaseToken token, const std::string& worker, std::int64_t unix_ms) {
  return db_.prepare("INSERT INTO attempt VALUES (?, ?, ?, ?, NULL, NULL, NULL)")
      .bind(static_cast<std::uint64_t>(token))
      .bind(static_cast<std::uint64_t>(job))
      .bind(worker)
      .bind(unix_ms)
      .run("start an attempt");
}

Result<void> Store::end_attempt(LeaseToken token, const std::string& outcome, const std::string& detail,
                                std::int64_t unix_ms) {
  return db_.prepare("UPDATE attempt SET ended_ms = ?, outcome = ?, detail = ? WHERE lease_token = ?")
      .bind(unix_ms)
      .bind(outcome)
      .bind(detail)
      .bind(static_cast<std::uint64_t>(token))
      .run("end an attempt");
}

Result<void> Store::add_artifact(const std::string& digest, std::uint64_t bytes, std::int64_t unix_ms) {
  return db_
      .prepare("INSERT INTO artifact VALUES (?, ?, ?) ON CONFLICT (digest) DO UPDATE SET created_ms = excluded.created_ms")
      .bind(digest)
      .bind(bytes)
      .bind(unix_ms)
      .run("store an artifact");
}

Result<void> Store::drop_artifact_row(const std::string& digest) {
  return db_
      .prepare(
          "DELETE FROM artifact WHERE digest = ?1 AND digest NOT IN (SELECT bed FROM job WHERE bed = ?1) "
          "AND digest NOT IN (SELECT checkpoint FROM job WHERE checkpoint = ?1)")
      .bind(digest)
      .run("drop an artifact");
}

bool Store::knows_artifact(const std::string& digest) {
  return db_.prepare("SELECT 1 FROM artifact WHERE digest = ?").bind(digest).step();
}

Result<std::vector<std::string>> Store::sweep(std::int64_t unix_ms) {
  std::vector<std::string> digests;
  Statement s = db_.prepare(
      "DELETE FROM artifact WHERE created_ms < ? AND digest NOT IN (SELECT bed FROM job WHERE bed IS NOT NULL) "
      "AND digest NOT IN (SELECT checkpoint FROM job WHERE checkpoint IS NOT NULL) RETURNING digest");
  s.bind(unix_ms);
  while (s.step()) digests.push_back(s.text(0));
  if (auto end = s.end("sweep artifacts"); !end.ok()) return end.error();
  return digests;
}

void Store::remove_orphans() {
  for (const std::string& digest : files_.list()) {
    if (!knows_artifact(digest)) files_.remove(digest);
  }
}

}  // namespace regolab
