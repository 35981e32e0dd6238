/// What must hold of a database whatever happened to the programs: nothing lost, nothing doubled, nothing half-written.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "store/artifact_files.h"
#include "store/database.h"

namespace regolab::test {

inline std::int64_t count(Database& db, const char* sql) {
  Statement statement = db.prepare(sql);
  return statement.step() ? statement.integer(0) : -1;
}

/// REQUIRES: no scheduler runs on it.
inline void audit(const std::string& path, bool all_done) {
  auto opened = Database::open(path, Access::kWrite);  // a reader could not look at a log nobody has open
  ASSERT_TRUE(opened.ok()) << opened.error().text;
  Database& db = *opened;
  {
    Statement check = db.prepare("PRAGMA integrity_check");
    ASSERT_TRUE(check.step());
    EXPECT_EQ(check.text(0), "ok");
  }
  EXPECT_EQ(count(db, "SELECT count(*) FROM pragma_foreign_key_check"), 0);
  EXPECT_EQ(count(db, "SELECT count(*) FROM job WHERE (state = 'succeeded') <> (id IN (SELECT job FROM result))"), 0)
      << "succeeded jobs are those with a result";
  EXPECT_EQ(count(db,
                  "SELECT count(*) FROM result r WHERE (SELECT count(*) FROM attempt a WHERE a.job = r.job AND "
                  "a.outcome = 'result') <> 1"),
            0)
      << "one attempt alone brought each result";
  EXPECT_EQ(count(db,
                  "SELECT count(*) FROM result r JOIN attempt a ON a.lease_token = r.lease_token WHERE a.job <> r.job OR "
                  "a.outcome <> 'result' OR a.lease_token <> (SELECT max(lease_token) FROM attempt WHERE job = r.job)"),
            0)
      << "it came under the job's newest lease";
  EXPECT_EQ(
      count(db,
            "SELECT count(*) FROM (SELECT experiment, max(seq) - count(*) AS gap, min(seq) AS first FROM event GROUP BY "
            "experiment) WHERE gap <> 0 OR first <> 1"),
      0)
      << "events are numbered without gaps";
  if (!all_done) return;
  EXPECT_EQ(count(db, "SELECT count(*) FROM job WHERE state <> 'succeeded'"), 0);
  EXPECT_EQ(count(db, "SELECT count(*) FROM attempt WHERE outcome IS NULL"), 0);
  const auto files = ArtifactFiles::open(path + ".d");
  Statement beds = db.prepare("SELECT bed FROM job WHERE stage = 'settle'");
  while (beds.step()) EXPECT_TRUE(files->read(beds.text(0)).ok()) << "every bed is there, whole";
}

}  // namespace regolab::test
