#include "store/store.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "store/reader.h"
#include "support/temp_dir.h"
#include "support/wishes.h"

namespace regolab {
namespace {

using test::stage;
using test::TempDir;

JobRecord job(std::uint64_t id, const StageSpec& spec, JobState state = JobState::kLeased) {
  JobRecord record{{JobId{id}, stage_key(spec), spec, {}}, {}};
  record.status.state = state;
  record.status.token = LeaseToken{7};
  record.status.worker = "w";
  return record;
}

ExperimentRecord experiment(std::uint64_t id) {
  ExperimentRecord r;
  r.id = ExperimentId{id};
  r.label = "study-" + std::to_string(id), r.name = "study", r.request_id = "r" + std::to_string(id),
  r.digest = "d" + std::to_string(id);
  r.design_yaml = "name: study\n", r.array = "L4", r.summary = "{}";
  r.factors = {{"theta_F", "degree", {"10", "20"}}, {"N_E", "1", {"2", "mixture"}}};
  r.levels = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  r.responses = {{"bulk_density", "kg/m3", StageKind::kFabric}};
  r.attachments = {{"table.csv", std::string("a\0b", 3)}};
  return r;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct StoreTest : testing::Test {
  TempDir dir;
  std::string path = dir / "lab.db";
  std::unique_ptr<Store> store = std::move(Store::open(path)).value();

  void commit(const std::function<Result<void>()>& work) {
    ASSERT_TRUE(store->begin().ok());
    const auto done = work();
    ASSERT_TRUE(done.ok()) << done.error().text;
    ASSERT_TRUE(store->commit().ok());
  }
};

TEST_F(StoreTest, AStageResultComesBackBitEqual) {
  StageResult result;
  result.end = StageEnd::kNotSettled;
  result.reason = "time limit (why) remedy";
  const double nan = std::bit_cast<double>(0x7ff8dead0000beefULL);
  result.measurements = {{"a", 0.1 + 0.2, "1", 1e-300, "x"},
                         {"b", nan, "Pa", -0.0, ""},
                         {"c", -0.0, "m", std::nullopt, ""},
                         {"d", std::numeric_limits<double>::infinity(), "s", 5e-324, ""}};
  result.numerics = {{"steps", 9007199254740993.0, "1", {}, ""}, {"e", 3.0, "1", {}, ""}};
  result.curves = {{"curve", "stress", "axial_strain", "1", "sigma1", "Pa", {0, 0.1, -0.0}, {1, nan, 3, 4}},
                   {"empty", "t", "", "", "", "", {}, {}}};
  commit([&] { return store->add_job(job(1, stage(StageKind::kStress, 3, 1250))); });
  commit([&] { return store->accept_result({JobId{1}, LeaseToken{7}, 1.5, 10, 0}, result); });

  auto reader = Reader::open(path);
  ASSERT_TRUE(reader.ok());
  const auto back = reader->result(JobId{1});
  ASSERT_TRUE(back.ok()) << back.error().text;
  ASSERT_EQ(back->measurements.size(), result.measurements.size());
  for (std::size_t i = 0; i < result.measurements.size(); ++i) {
    EXPECT_TRUE(same_bits(back->measurements[i].value, result.measurements[i].value)) << i;
    ASSERT_EQ(back->measurements[i].standard_error.has_value(), result.measurements[i].standard_error.has_value());
    EXPECT_TRUE(
        same_bits(back->measurements[i].standard_error.value_or(0), result.measurements[i].standard_error.value_or(0)));
  }
  EXPECT_EQ(back->numerics, result.numerics);
  EXPECT_EQ(back->end, result.end);
  EXPECT_EQ(back->reason, result.reason);
  ASSERT_EQ(back->curves.size(), 2U);
  ASSERT_EQ(back->curves[0].y.size(), 4U);
  EXPECT_EQ(back->curves[0].x.size(), 3U);
  EXPECT_TRUE(same_bits(back->curves[0].x[2], -0.0));
  EXPECT_TRUE(same_bits(back->curves[0].y[1], nan));
  EXPECT_EQ(back->curves[1], result.curves[1]);
}

TEST_F(StoreTest, AStaleLeaseTokenIsRefusedInTheTransactionThatWrites) {
  commit([&] { return store->add_job(job(1, stage(StageKind::kSettle, 1))); });
  ASSERT_TRUE(store->begin().ok());
  const auto refused = store->accept_result({JobId{1}, LeaseToken{6}, 1, 1, 0}, {});
  store->rollback();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Code::kAborted);
  JobRecord ended = job(2, stage(StageKind::kSettle, 2), JobState::kReady);
  commit([&] { return store->add_job(ended); });
  ASSERT_TRUE(store->begin().ok());
  EXPECT_FALSE(store->accept_result({JobId{2}, LeaseToken{7}, 1, 1, 0}, {}).ok()) << "the job is not leased any more";
  store->rollback();
}

TEST_F(StoreTest, EverythingTheQueueNeedsComesBackAfterAReopen) {
  StageSpec spec = stage(StageKind::kSettle, 18446744073709551615ULL);
  spec.micro.kind = ParticleKind::kMixture;
  spec.micro.rotation = Rotation::kXZ;
  spec.micro.damping_unit = DampingUnit::kRatio;
  spec.numerics.box_length = 0.1234567890123456789;
  JobRecord settle = job(1, spec);
  StageSpec child_spec = spec;
  child_spec.kind = StageKind::kStress;
  child_spec.confining_stress = 1250;
  JobRecord child = job(2, child_spec, JobState::kBlocked);
  child.identity.parent = JobId{1};
  const std::string digest = sha256_hex("bed");
  commit([&] {
    (void)store->add_experiment(experiment(1)).ok();
    (void)store->add_job(settle).ok();
    (void)store->add_job(child).ok();
    (void)store->link({ExperimentId{1}, JobId{1}, 1, 5, true}).ok();
    (void)store->link({ExperimentId{1}, JobId{2}, 1, 5, false}).ok();
    (void)store->add_event(ExperimentId{1}, 1, 0, "submitted").ok();
    return store->add_artifact(digest, 3, 0);
  });
  commit([&] { return store->accept_result({JobId{1}, LeaseToken{7}, 2.5, 99, 0}, {}); });
  settle.status.state = JobState::kSucceeded;
  settle.status.bed = digest;
  settle.status.end = StageEnd::kCompleted;
  settle.status.wall_s = 2.5;
  settle.status.steps = 99;
  commit([&] { return store->change_job(JobId{1}, settle.status); });
  store.reset();
  store = std::move(Store::open(path)).value();
  const auto snapshot = store->load();
  ASSERT_TRUE(snapshot.ok()) << snapshot.error().text;
  ASSERT_EQ(snapshot->jobs.size(), 2U);
  EXPECT_EQ(snapshot->jobs[0].identity.spec, spec);
  EXPECT_EQ(snapshot->jobs[0].status, settle.status);
  EXPECT_EQ(snapshot->jobs[1].identity.spec, child_spec);
  EXPECT_EQ(snapshot->jobs[1].identity.parent, JobId{1});
  EXPECT_EQ(snapshot->studies.at(0).next_seq, 2U);
  EXPECT_EQ(snapshot->links.size(), 2U);
  EXPECT_TRUE(snapshot->links[0].reused);
  auto reader = Reader::open(path);
  const auto design = reader->design("study-1");
  ASSERT_TRUE(design.ok());
  EXPECT_EQ(design->levels, experiment(1).levels);
  EXPECT_EQ(design->factors.at(1).levels, (std::vector<std::string>{"2", "mixture"}));
  EXPECT_EQ(design->responses, experiment(1).responses);
  EXPECT_EQ(reader->design("none").error().code, Code::kNotFound);
}

TEST_F(StoreTest, WhatWasNotCommittedIsNotThere) {
  ASSERT_TRUE(store->begin().ok());
  ASSERT_TRUE(store->add_job(job(1, stage(StageKind::kSettle, 1))).ok());
  store->rollback();
  EXPECT_TRUE(store->load()->jobs.empty());
}

TEST_F(StoreTest, BootNumbersStrictlyRiseEvenWhenTheClockGoesBack) {
  const auto first = store->next_boot(1'800'000'000);
  const auto second = store->next_boot(1'000'000'000);
  EXPECT_GT(*second, *first);
}

TEST_F(StoreTest, ASecondSchedulerIsRefused) {
  const auto second = Store::open(path);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().code, Code::kFailedPrecondition);
  EXPECT_NE(second.error().text.find("the database is in use"), std::string::npos) << second.error().text;
  EXPECT_NE(second.error().text.find(std::to_string(getpid())), std::string::npos);
}

TEST_F(StoreTest, ANewerDatabaseIsRefusedAndLeftAsItIs) {
  store.reset();
  {
    auto db = Database::open(path, Access::kWrite);
    ASSERT_TRUE(db->run("PRAGMA user_version = 99", "age").ok());
  }
  const auto opened = Store::open(path);
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().text.find("newer regolab (schema 99"), std::string::npos) << opened.error().text;
}

TEST_F(StoreTest, AnotherProgramsDatabaseIsRefused) {
  const std::string other = dir / "other.db";
  {
    auto db = Database::open(other, Access::kWrite);
    ASSERT_TRUE(db->run("CREATE TABLE t (x)", "make").ok());
  }
  EXPECT_NE(Store::open(other).error().text.find("not a regolab database"), std::string::npos);
  FILE* file = fopen((dir / "text.db").c_str(), "w");
  fputs("this is a text file, long enough to be looked at as a database header ............................", file);
  fclose(file);
  EXPECT_EQ(Store::open(dir / "text.db").error().code, Code::kFailedPrecondition);
}

TEST_F(StoreTest, AFullDatabaseRollsBackAndRecovers) {
  StageResult large;
  large.curves = {{"c", "stress", "x", "1", "y", "Pa", std::vector<double>(4000, 0.1), std::vector<double>(4000, 0.2)}};
  commit([&] { return store->add_job(job(1, stage(StageKind::kSettle, 1))); });
  ASSERT_TRUE(store->limit_pages(60).ok());
  ASSERT_TRUE(store->begin().ok());
  const auto full = store->accept_result({JobId{1}, LeaseToken{7}, 1, 1, 0}, large);
  store->rollback();
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().code, Code::kResourceExhausted) << full.error().text;
  EXPECT_EQ(Reader::open(path)->result(JobId{1}).error().code, Code::kNotFound) << "nothing half-written";
  ASSERT_TRUE(store->limit_pages(100000).ok());
  commit([&] { return store->accept_result({JobId{1}, LeaseToken{7}, 1, 1, 0}, large); });
  EXPECT_EQ(*Reader::open(path)->result(JobId{1}), large);
}

TEST_F(StoreTest, ForgettingAResultTakesItsNumbersAlong) {
  StageResult result;
  result.measurements = {{"a", 1, "1", {}, ""}};
  result.curves = {{"c", "t", "x", "1", "y", "1", {1}, {2}}};
  commit([&] { return store->add_job(job(1, stage(StageKind::kSettle, 1))); });
  commit([&] { return store->accept_result({JobId{1}, LeaseToken{7}, 1, 1, 0}, result); });
  commit([&] { return store->forget_result(JobId{1}); });
  commit([&] { return store->accept_result({JobId{1}, LeaseToken{7}, 1, 1, 0}, result); });
  EXPECT_EQ(*Reader::open(path)->result(JobId{1}), result);
}

TEST_F(StoreTest, SweepTakesOnlyWhatNobodyRefersTo) {
  const std::string used = sha256_hex("used"), unused = sha256_hex("unused");
  JobRecord leased = job(1, stage(StageKind::kSettle, 1));
  commit([&] {
    (void)store->add_job(leased).ok();
    (void)store->add_artifact(used, 1, 0).ok();
    return store->add_artifact(unused, 1, 0);
  });
  leased.status.checkpoint = used;
  commit([&] { return store->change_job(JobId{1}, leased.status); });
  std::vector<std::string> swept;
  commit([&]() -> Result<void> {
    swept = *store->sweep(10);
    return {};
  });
  EXPECT_EQ(swept, std::vector{unused});
}

DiagnosisRecord diagnosis(const std::string& id, std::int64_t created_ms) {
  return {.id = id, .case_name = "quarry", .created_ms = created_ms, .observations = "o", .bank = "b", .kernels = "k", .method = "m", .options = "{\"seed\":1}", .held_out = "",
          .measurements = std::string("x\0y", 3)};
}

TEST_F(StoreTest, ADiagnosisComesBackWithItsStepsInTheOrderTheyWereDone) {
  commit([&]() -> Result<void> {
    EXPECT_TRUE(store->add_diagnosis(diagnosis("d1", 10)).ok());
    EXPECT_TRUE(store->add_diagnosis_step("d1", {"where", 11, std::string("\0\1", 2)}).ok());
    EXPECT_TRUE(store->add_diagnosis_step("d1", {"evidence: none", 12, "z"}).ok());
    return store->add_diagnosis_step("d1", {"where", 13, "another"});  // done already: the first stays
  });
  Reader reader = std::move(Reader::open(path)).value();
  const auto found = reader.diagnosis("d");
  ASSERT_TRUE(found.ok()) << found.error().text;
  EXPECT_EQ(found->case_name, "quarry");
  EXPECT_EQ(found->options, "{\"seed\":1}");
  EXPECT_EQ(found->measurements, std::string("x\0y", 3));
  EXPECT_FALSE(found->ended_ms);
  const auto steps = reader.diagnosis_steps("d1");
  ASSERT_EQ(steps->size(), 2U);
  EXPECT_EQ(steps->at(0).name, "where");
  EXPECT_EQ(steps->at(0).result, std::string("\0\1", 2));
  EXPECT_EQ(steps->at(1).done_ms, 12);
}

TEST_F(StoreTest, ADiagnosisEndsOnceAndIsAddedOnce) {
  commit([&]() -> Result<void> {
    EXPECT_TRUE(store->add_diagnosis(diagnosis("d1", 10)).ok());
    EXPECT_TRUE(store->end_diagnosis("d1", "first", 20).ok());
    EXPECT_TRUE(store->end_diagnosis("d1", "second", 30).ok());
    EXPECT_TRUE(store->set_shrinkage("d1", "s").ok());
    return store->add_diagnosis(diagnosis("d1", 40));
  });
  Reader reader = std::move(Reader::open(path)).value();
  const auto found = reader.diagnosis("d1");
  EXPECT_EQ(found->result, "first");
  EXPECT_EQ(found->ended_ms, 20);
  EXPECT_EQ(found->created_ms, 10);
  EXPECT_EQ(found->shrinkage, "s");
}

TEST_F(StoreTest, DiagnosesAreListedNewestFirstAndFoundByAStartThatIsOneOnly) {
  commit([&]() -> Result<void> {
    EXPECT_TRUE(store->add_diagnosis(diagnosis("ab1", 10)).ok());
    return store->add_diagnosis(diagnosis("ab2", 20));
  });
  Reader reader = std::move(Reader::open(path)).value();
  const auto all = reader.diagnoses();
  ASSERT_EQ(all->size(), 2U);
  EXPECT_EQ(all->front().id, "ab2");
  EXPECT_EQ(reader.diagnosis("ab").error().code, Code::kInvalidArgument);
  EXPECT_EQ(reader.diagnosis("c").error().code, Code::kNotFound);
  EXPECT_EQ(reader.diagnosis("ab1")->id, "ab1");
}

TEST_F(StoreTest, AStepOfNoDiagnosisIsRefused) {
  ASSERT_TRUE(store->begin().ok());
  EXPECT_EQ(store->add_diagnosis_step("none", {"where", 1, ""}).error().code, Code::kAborted);
  store->rollback();
}

}  // namespace
}  // namespace regolab
