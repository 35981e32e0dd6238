#include "worker/output/job_run.h"

#include <gmock/gmock.h>

#include <fstream>

#include "digest/sha256.h"
#include "unit/output/fake_stages.h"
#include "unit/output/temporary_folder.h"
#include "worker/output/atomic_file.h"

namespace regolab {
namespace {

using test::FakeStages;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

JobHooks hooks_for(FakeStages& fake, std::stop_token stop = {}) {
  return {.run_stage = [&fake](const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                               const StageHooks& hooks) { return fake.run(spec, bed, checkpoint, hooks); },
          .stop = stop};
}

std::vector<StageResult> results_of(const JobRun& run) {
  std::vector<StageResult> results;
  for (const KeptStage& kept : run.stages) results.push_back(kept.stage.result);
  return results;
}

JobRun undisturbed(const Job& job) {
  const TemporaryFolder folder;
  FakeStages fake;
  const auto store = StageStore::open(folder.path(), job);
  return run_job(job, *store, hooks_for(fake)).value();
}

TEST(RunJob, StoppedInTheMiddleGoesOnAndEndsWithTheSameBits) {
  const Job job = test::small_job();
  const JobRun whole = undisturbed(job);
  for (const std::uint64_t stop_at : {0u, 37u, 99u}) {
    const TemporaryFolder folder;
    const auto store = StageStore::open(folder.path(), job);
    std::stop_source stop;
    FakeStages first;
    first.at_step = [&](const StageSpec& spec, std::uint64_t step) {
      if (spec.kind == StageKind::kRepose && step == stop_at) stop.request_stop();
    };
    const auto cut = run_job(job, *store, hooks_for(first, stop.get_token()));
    ASSERT_TRUE(cut.ok());
    const bool reached_the_end = stop_at + 1 == first.steps;  // stopped after its last step, repose is complete
    EXPECT_TRUE(cut->interrupted);
    EXPECT_EQ(cut->stages.size(), reached_the_end ? 3u : 2u);

    FakeStages second;
    const auto rest = run_job(job, *store, hooks_for(second));
    ASSERT_TRUE(rest.ok());
    EXPECT_EQ(second.started.front(), reached_the_end ? StageKind::kStress : StageKind::kRepose)
        << "finished stages ran again";
    EXPECT_EQ(first.steps_done + second.steps_done, 5 * first.steps) << "steps were lost or doubled";
    EXPECT_EQ(results_of(*rest), results_of(whole));
    EXPECT_EQ(rest->stages[0].state, whole.stages[0].state);
    EXPECT_EQ(rest->stages[2].state, whole.stages[2].state);
  }
}

TEST(RunJob, KilledBetweenCheckpointsRepeatsOnlyWhatCameAfterTheLast) {
  const Job job = test::small_job();
  const TemporaryFolder folder;
  std::uint64_t steps_before = 0;
  {
    const auto store = StageStore::open(folder.path(), job);
    FakeStages killed;
    struct Killed {};
    killed.at_step = [](const StageSpec&, std::uint64_t step) {
      if (step == 37) throw Killed{};
    };
    EXPECT_THROW(static_cast<void>(run_job(job, *store, hooks_for(killed))), Killed);
    steps_before = killed.steps_done;
  }
  const auto store = StageStore::open(folder.path(), job);
  FakeStages again;
  const auto run = run_job(job, *store, hooks_for(again));
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(results_of(*run), results_of(undisturbed(job)));
  EXPECT_EQ(steps_before + again.steps_done, 5 * again.steps + 7) << "30 to 37 twice, nothing else";
}

TEST(RunJob, WithADamagedCheckpointSaysSoAndStartsTheStageAfresh) {
  const Job job = test::small_job();
  const TemporaryFolder folder;
  const auto store = StageStore::open(folder.path(), job);
  ASSERT_TRUE(store->save_checkpoint(stages_of(job)[0], "rubbish").ok());
  FakeStages fake;
  JobHooks hooks = hooks_for(fake);
  std::string notes;
  hooks.on_note = [&](const std::string& text) { notes += text; };
  const auto run = run_job(job, *store, hooks);
  ASSERT_TRUE(run.ok());
  EXPECT_THAT(notes, HasSubstr("settle: starts afresh (checkpoint is damaged)"));
  EXPECT_EQ(results_of(*run), results_of(undisturbed(job)));
}

TEST(RunJob, WithADamagedRecordRunsThatStageAgain) {
  const Job job = test::small_job();
  const TemporaryFolder folder;
  const auto store = StageStore::open(folder.path(), job);
  FakeStages first;
  ASSERT_TRUE(run_job(job, *store, hooks_for(first)).ok());
  const auto bed_file = folder.path() / ".checkpoint" / (stage_key(stages_of(job)[0]) + ".state");
  std::ofstream(bed_file, std::ios::app) << "x";
  FakeStages second;
  const auto run = run_job(job, *store, hooks_for(second));
  EXPECT_THAT(second.started, ElementsAre(StageKind::kSettle));
  EXPECT_EQ(results_of(*run), results_of(undisturbed(job)));
}

TEST(RunJob, WithoutASettledBedEndsThere) {
  const TemporaryFolder folder;
  const auto store = StageStore::open(folder.path(), test::small_job());
  FakeStages fake;
  fake.end_of = [](const StageSpec&) { return StageEnd::kNotSettled; };
  const auto run = run_job(test::small_job(), *store, hooks_for(fake));
  ASSERT_TRUE(run.ok());
  EXPECT_THAT(fake.started, ElementsAre(StageKind::kSettle));
  EXPECT_EQ(run->stages.size(), 1u);
}

TEST(RunJob, AnUnphysicalStressTestDoesNotEndTheOthers) {
  const TemporaryFolder folder;
  const auto store = StageStore::open(folder.path(), test::small_job());
  FakeStages fake;
  fake.end_of = [](const StageSpec& spec) {
    return spec.confining_stress == 1250 ? StageEnd::kOverlap : StageEnd::kCompleted;
  };
  const auto run = run_job(test::small_job(), *store, hooks_for(fake));
  ASSERT_EQ(run->stages.size(), 5u);
  EXPECT_EQ(run->stages[3].stage.result.end, StageEnd::kOverlap);
  EXPECT_EQ(run->stages[4].stage.result.end, StageEnd::kCompleted);
}

TEST(RunJob, StopsWhenACheckpointCannotBeWritten) {
  const TemporaryFolder folder;
  const auto store = StageStore::open(folder.path(), test::small_job());
  std::filesystem::remove_all(folder.path() / ".checkpoint");
  FakeStages fake;
  const auto run = run_job(test::small_job(), *store, hooks_for(fake));
  ASSERT_FALSE(run.ok());
  EXPECT_THAT(run.error().text, HasSubstr("cannot be written"));
  EXPECT_LT(fake.steps_done, fake.steps);
}

TEST(StageStore, RefusesAFolderWhereAnotherRunWorks) {
  const TemporaryFolder folder;
  const auto first = StageStore::open(folder.path(), test::small_job());
  ASSERT_TRUE(first.ok());
  const auto second = StageStore::open(folder.path(), test::small_job());
  ASSERT_FALSE(second.ok());
  EXPECT_THAT(second.error().text, HasSubstr("another run works in it"));
}

TEST(StageStore, RefusesAFolderWithAnUnfinishedRunOfAnotherJob) {
  const TemporaryFolder folder;
  ASSERT_TRUE(StageStore::open(folder.path(), test::small_job()).ok());
  Job other = test::small_job();
  other.seed = 2;
  const auto opened = StageStore::open(folder.path(), other);
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().code, Code::kAlreadyExists);
  EXPECT_THAT(opened.error().text, HasSubstr("an unfinished run of another job"));
}

}  // namespace
}  // namespace regolab
