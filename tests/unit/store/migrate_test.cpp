/// Files of older schemas, opened by today's program.
#include "store/migrate.h"

#include <gtest/gtest.h>

#include "schema.h"
#include "store/store.h"
#include "support/temp_dir.h"
#include "support/wishes.h"

namespace regolab {
namespace {

std::int64_t number(Database& db, const char* query) {
  Statement s = db.prepare(query);
  return s.step() ? s.integer(0) : -1;
}
std::string text(Database& db, const char* query) {
  Statement s = db.prepare(query);
  return s.step() ? s.text(0) : "";
}
constexpr const char* kVersion = "PRAGMA user_version";
constexpr const char* kCookie = "PRAGMA schema_version";  // SQLite's own count of changes to the schema
constexpr const char* kNewColumn = "SELECT count(*) FROM pragma_table_info('job') WHERE name = 'most_damping_ratio'";
constexpr const char* kSchemaText = "SELECT group_concat(sql, ';') FROM sqlite_schema";

/// What version 1 could say of a job; its row below holds just that.
JobRecord old_job() {
  StageSpec spec = test::stage(StageKind::kSettle, 7);
  spec.micro.kind = ParticleKind::kMixture;
  spec.micro.damping_unit = DampingUnit::kRatio;
  JobRecord record{{JobId{3}, "key-as-version-1-computed-it", spec, {}}, {}};
  record.status.state = JobState::kSucceeded;
  record.status.token = LeaseToken{9};
  record.status.worker = "w";
  record.status.attempts = 2;
  record.status.detail = "said so";
  record.status.end = StageEnd::kCompleted;
  record.status.wall_s = 2.5;
  record.status.steps = 99;
  return record;
}

constexpr const char* kRowsOfVersion1 =
    "INSERT INTO experiment VALUES (1, 'study-1', 'study', 'r1', 'd1', 'name: study', 'study.yaml', 'table', '{}', 'running', 10, NULL);"
    "INSERT INTO job VALUES (3, 'key-as-version-1-computed-it', 'settle', NULL, 7, 0.0, 0.3, 1e5, 0.25, 7.5e4, 1.0, 0.01, ?, ?, ?, ?, ?,"
    " ?, ?, ?, ?, ?, ?, ?, ?, ?, 'succeeded', 9, 'w', 2, 0, 0, 0, 'said so', NULL, NULL);"
    "INSERT INTO experiment_job VALUES (1, 0, 3, 5, 7, 0);"
    "INSERT INTO result VALUES (3, 9, 0, 'completed', '', 2.5, 99, 20);";

/// Runs statements one after the other; the second has the numbers that are defaults of the specification.
void insert_rows(Database& db, const StageSpec& spec) {
  const Micro& m = spec.micro;
  const Numerics& n = spec.numerics;
  const char* rest = kRowsOfVersion1;
  while (*rest) {
    sqlite3_stmt* raw = nullptr;
    ASSERT_EQ(sqlite3_prepare_v2(db.raw(), rest, -1, &raw, &rest), SQLITE_OK) << sqlite3_errmsg(db.raw());
    {
      Statement s(db.raw(), raw);
      if (sqlite3_bind_parameter_count(raw) > 0) {
        s.bind(static_cast<int>(m.kind)).bind(static_cast<int>(m.rotation)).bind(static_cast<int>(m.damping_unit));
        s.bind(m.grain_density).bind(m.gravity).bind(n.clusters).bind(n.box_length).bind(n.box_width);
        s.bind(n.settle_stiffness_number).bind(n.stress_stiffness_number).bind(n.mass_floor).bind(n.step_fraction);
        s.bind(n.inertial_number).bind(n.axial_strain);
      }
      const auto inserted = s.run("insert");
      ASSERT_TRUE(inserted.ok()) << inserted.error().text;
    }
    sqlite3_finalize(raw);
  }
}

struct MigrateTest : testing::Test {
  test::TempDir dir;
  std::string path = dir / "lab.db";

  Database raw() { return std::move(Database::open(path, Access::kWrite)).value(); }

  /// As the first release left it.
  void make_version_1() {
    Database db = raw();
    Transaction whole{db};
    ASSERT_TRUE(db.run(kSchema, "make").ok());
    ASSERT_TRUE(db.run(("PRAGMA application_id=" + std::to_string(kApplicationId) + "; PRAGMA user_version=1").c_str(), "make").ok());
    insert_rows(db, old_job().identity.spec);
    ASSERT_TRUE(whole.commit().ok());
    ASSERT_EQ(number(db, kNewColumn), 0);
  }

  void expect_the_old_job() {
    auto store = Store::open(path);
    ASSERT_TRUE(store.ok()) << store.error().text;
    const auto snapshot = (*store)->load();
    ASSERT_TRUE(snapshot.ok()) << snapshot.error().text;
    ASSERT_EQ(snapshot->jobs.size(), 1U);
    const JobRecord& job = snapshot->jobs[0];
    EXPECT_EQ(job.identity.spec.numerics.most_damping_ratio, 0);
    EXPECT_EQ(job.identity.spec, old_job().identity.spec);
    EXPECT_EQ(job.identity.key, old_job().identity.key);
    EXPECT_EQ(job.status, old_job().status);
    ASSERT_EQ(snapshot->studies.size(), 1U);
    EXPECT_EQ(snapshot->studies[0].record.label, "study-1");
    ASSERT_EQ(snapshot->links.size(), 1U);
    EXPECT_EQ(snapshot->links[0].job, JobId{3});
  }
};

TEST_F(MigrateTest, AFileOfVersion1OpensWithItsJobsWhoseDashpotsStayAsGiven) {
  make_version_1();
  expect_the_old_job();
  Database db = raw();
  EXPECT_EQ(number(db, kVersion), kSchemaVersion);
  EXPECT_EQ(number(db, kNewColumn), 1);
}

TEST_F(MigrateTest, ASecondOpenChangesNothing) {
  make_version_1();
  ASSERT_TRUE(Store::open(path).ok());
  std::int64_t cookie = 0;
  std::string schema;
  {
    Database db = raw();
    cookie = number(db, kCookie), schema = text(db, kSchemaText);
  }
  expect_the_old_job();
  Database db = raw();
  EXPECT_EQ(number(db, kVersion), kSchemaVersion);
  EXPECT_EQ(number(db, kCookie), cookie);
  EXPECT_EQ(text(db, kSchemaText), schema);
}

TEST_F(MigrateTest, AMigratedFileHasWhatANewOneHasAndTakesNewJobs) {
  make_version_1();
  StageSpec capped = test::stage(StageKind::kSettle, 8);
  capped.numerics.most_damping_ratio = 0.75;
  StageSpec plate = test::stage(StageKind::kPenetration, 9);
  plate.plate = {.width = 0.03, .thickness = 0.003};
  StageSpec sticky = test::stage(StageKind::kSettle, 10);
  sticky.effects[EffectId::kCohesion] = 1.0 / 3;
  sticky.effects[EffectId::kRollingResistance] = 0.3;
  StageSpec gentle = test::stage(StageKind::kStress, 11);
  gentle.numerics.isotropic_servo_steps = 200;
  {
    auto store = Store::open(path);
    ASSERT_TRUE(store.ok()) << store.error().text;
    ASSERT_TRUE((*store)->begin().ok());
    ASSERT_TRUE((*store)->add_job({{JobId{4}, stage_key(capped), capped, {}}, {}}).ok());
    const auto added = (*store)->add_job({{JobId{5}, stage_key(plate), plate, {}}, {}});
    ASSERT_TRUE(added.ok()) << added.error().text;
    ASSERT_TRUE((*store)->add_job({{JobId{6}, stage_key(sticky), sticky, {}}, {}}).ok());
    ASSERT_TRUE((*store)->add_job({{JobId{7}, stage_key(gentle), gentle, {}}, {}}).ok());
    ASSERT_TRUE((*store)->commit().ok());
  }
  {
    auto store = Store::open(path);
    EXPECT_EQ((*store)->load()->jobs.at(1).identity.spec, capped);
    EXPECT_EQ((*store)->load()->jobs.at(2).identity.spec, plate);
    EXPECT_EQ((*store)->load()->jobs.at(3).identity.spec, sticky);
    EXPECT_EQ((*store)->load()->jobs.at(4).identity.spec, gentle);
  }
  {
    Database db = raw();
    EXPECT_EQ(text(db, "SELECT effects FROM job WHERE id = 6"), "cohesion=0.3333333333333333;rolling_resistance=0.3");
    EXPECT_EQ(text(db, "SELECT effects FROM job WHERE id = 3"), "") << "the base model, as it was";
    EXPECT_EQ(text(db, "SELECT isotropic_servo_steps FROM job WHERE id = 3"), "50.0") << "as it was";
  }
  const char* columns = "SELECT group_concat(name || ' ' || type || ' ' || \"notnull\") FROM pragma_table_info('job')";
  const std::string fresh_path = dir / "fresh.db";
  ASSERT_TRUE(Store::open(fresh_path).ok());
  Database migrated = raw(), fresh = std::move(Database::open(fresh_path, Access::kWrite)).value();
  EXPECT_EQ(text(migrated, columns), text(fresh, columns));
  EXPECT_FALSE(migrated.run("UPDATE job SET stage = 'dream'", "break the check").ok());
  EXPECT_EQ(text(migrated, "PRAGMA integrity_check"), "ok");
  const char* parts = "SELECT group_concat(part) FROM (SELECT type || ' ' || name AS part FROM sqlite_schema ORDER BY part)";
  EXPECT_EQ(text(migrated, parts), text(fresh, parts));
}

TEST_F(MigrateTest, AFileOfVersion6TakesDiagnosesAndKeepsItsJobs) {
  make_version_1();
  ASSERT_TRUE(Store::open(path).ok());
  {
    Database db = raw();  // back to what version 6 left
    ASSERT_TRUE(db.run("DROP TABLE diagnosis_step; DROP TABLE diagnosis; PRAGMA user_version=6", "go back").ok());
  }
  expect_the_old_job();
  {
    auto store = Store::open(path);
    ASSERT_TRUE((*store)->begin().ok());
    ASSERT_TRUE((*store)->add_diagnosis({.id = "d1", .case_name = "c", .measurements = std::string("a\0b", 3)}).ok());
    ASSERT_TRUE((*store)->add_diagnosis_step("d1", {"evidence: none", 5, "bytes"}).ok());
    ASSERT_TRUE((*store)->commit().ok());
  }
  Database db = raw();
  EXPECT_EQ(number(db, kVersion), kSchemaVersion);
  EXPECT_EQ(number(db, "SELECT count(*) FROM diagnosis JOIN diagnosis_step ON diagnosis = id"), 1);
}

/// Refuses the last statement, after the new column is there.
int refuse_the_version(void*, int action, const char* pragma, const char* value, const char*, const char*) {
  return action == SQLITE_PRAGMA && std::string_view(pragma) == "user_version" && value ? SQLITE_DENY : SQLITE_OK;
}

TEST_F(MigrateTest, AFailureInTheMiddleLeavesVersion1) {
  make_version_1();
  {
    Database db = raw();
    const std::string before = text(db, kSchemaText);
    sqlite3_set_authorizer(db.raw(), refuse_the_version, nullptr);
    EXPECT_FALSE(migrate(db).ok());
    sqlite3_set_authorizer(db.raw(), nullptr, nullptr);
    EXPECT_EQ(number(db, kVersion), 1);
    EXPECT_EQ(number(db, kNewColumn), 0);
    EXPECT_EQ(text(db, kSchemaText), before);
  }
  expect_the_old_job();  // the next try is a whole one
}

TEST_F(MigrateTest, AStepThatFailsIsAnErrorAndTheFileStaysAsItWas) {
  make_version_1();
  {
    Database db = raw();
    ASSERT_TRUE(db.run("ALTER TABLE job ADD COLUMN most_damping_ratio REAL", "get in the way").ok());
  }
  const auto opened = Store::open(path);
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().text.find("most_damping_ratio"), std::string::npos) << opened.error().text;
  Database db = raw();
  EXPECT_EQ(number(db, kVersion), 1);
}

}  // namespace
}  // namespace regolab
