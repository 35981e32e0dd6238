/// The writing side of the database. One object per file (a lock sees to it), used from one thread; that thread also
/// checkpoints. Every change happens inside begin() ... commit(); nothing is true before commit() returned well.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "store/artifact_files.h"
#include "store/database.h"
#include "store/lock_file.h"
#include "store/records.h"

namespace regolab {

class Store {
 public:
  /// Files: PATH (with -wal, -shm), PATH.lock, and PATH.d/ for artifacts. kFailedPrecondition: in use, newer, not ours.
  static Result<std::unique_ptr<Store>> open(const std::string& path);

  Result<void> begin() { return db_.run("BEGIN IMMEDIATE", "begin"); }
  Result<void> commit() { return db_.run("COMMIT", "commit"); }
  void rollback();
  /// Moves the log into the file; `empty_log` when there is time. A full disk is no loss: the log stays.
  Result<void> checkpoint(bool empty_log);
  /// After a full disk: can a page's worth be written again?
  Result<void> has_room();
  /// Refuses to grow beyond so many pages of 4 KiB, as a full disk would.
  Result<void> limit_pages(int pages);
  std::int64_t log_pages() const { return log_pages_; }

  /// The next boot's epoch: greater than every one before, and than the Unix time in seconds.
  Result<LeaseToken> next_boot(std::int64_t unix_s);
  Result<Snapshot> load();

  Result<void> add_experiment(const ExperimentRecord& record);
  Result<void> change_experiment(ExperimentId id, ExperimentState state, std::int64_t unix_ms);
  Result<void> add_job(const JobRecord& record);
  Result<void> change_job(JobId id, const JobStatus& status);
  Result<void> link(const JobLink& link);
  Result<void> start_attempt(JobId job, LeaseToken token, const std::string& worker, std::int64_t unix_ms);
  Result<void> end_attempt(LeaseToken token, const std::string& outcome, const std::string& detail, std::int64_t unix_ms);

  struct Acceptance {
    JobId job{};
    LeaseToken token{};
    double wall_s = 0;
    std::uint64_t steps = 0;
    std::int64_t unix_ms = 0;
  };
  /// kAborted: `token` is not the job's newest lease, or the job is not leased. The last gate before a result exists.
  Result<void> accept_result(const Acceptance& acceptance, const StageResult& result);
  Result<void> forget_result(JobId job);

  /// Known already: its time is renewed, so that it is the newest.
  Result<void> add_model(const ModelRecord& record);

  /// Known already: nothing changes.
  Result<void> add_diagnosis(const DiagnosisRecord& record);
  /// Known already: nothing changes. kAborted: no such diagnosis.
  Result<void> add_diagnosis_step(const std::string& diagnosis, const DiagnosisStep& step);
  Result<void> end_diagnosis(const std::string& id, const std::string& result, std::int64_t unix_ms);
  Result<void> set_shrinkage(const std::string& id, const std::string& shrinkage);

  Result<void> add_event(ExperimentId id, std::uint64_t seq, std::int64_t unix_ms, const std::string& text);
  Result<std::vector<EventRecord>> events(ExperimentId id, std::uint64_t from_seq, int limit);

  Result<void> add_artifact(const std::string& digest, std::uint64_t bytes, std::int64_t unix_ms);
  Result<void> drop_artifact_row(const std::string& digest);
  bool knows_artifact(const std::string& digest);
  /// Rows nobody refers to, older than `unix_ms`; the caller removes the files after the commit.
  Result<std::vector<std::string>> sweep(std::int64_t unix_ms);
  const ArtifactFiles& files() const { return files_; }
  /// Files without a row (a crash came between them) are removed. REQUIRES: no upload is under way.
  void remove_orphans();

 private:
  Store(LockFile lock, Database db, ArtifactFiles files);
  Result<void> insert_measurements(JobId job, const char* role, const std::vector<Measurement>& list);
  Result<void> insert_curve(JobId job, int n, const Curve& curve);

  LockFile lock_;
  Database db_;
  ArtifactFiles files_;
  std::int64_t log_pages_ = 0;
};

}  // namespace regolab
