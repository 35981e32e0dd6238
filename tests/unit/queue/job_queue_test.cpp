#include "scheduler/queue/job_queue.h"

#include <gtest/gtest.h>

#include "support/tables.h"
#include "support/wishes.h"

namespace regolab {
namespace {

using test::stage;
using test::study;
using test::Tables;

/// A queue with its tables and an own clock; one call = one committed step.
struct Lab {
  QueuePolicy policy;
  Tables tables;
  Millis now = 0;
  JobQueue queue{policy, LeaseToken{100}};
  std::map<std::string, std::uint64_t> seq;

  ExperimentId submit(const std::vector<Wish>& wishes) {
    Effects effects;
    const ExperimentId id = queue.submit(wishes, now, effects);
    tables.apply(effects);
    return id;
  }
  std::optional<Order> report(const std::string& worker, decltype(WorkerReport::slot) slot, bool draining = false) {
    Effects effects;
    auto order = queue.exchange({worker, ++seq[worker], draining, std::move(slot)}, now, effects);
    tables.apply(effects);
    return order;
  }
  OrderStart start(const std::string& worker) {
    const auto order = report(worker, WorkerIdle{});
    EXPECT_TRUE(order && std::holds_alternative<OrderStart>(*order)) << worker << " got no job";
    return order && std::holds_alternative<OrderStart>(*order) ? std::get<OrderStart>(*order) : OrderStart{};
  }
  std::optional<Order> finish(const std::string& worker, const OrderStart& job, StageEnd end = StageEnd::kCompleted) {
    auto result = std::make_shared<StageResult>();
    result->end = end;
    if (end != StageEnd::kCompleted) result->reason = "it did not";
    return report(worker, WorkerFinished{job.job, job.token, result, needs_bed(job.spec.kind) ? "" : "bed", 1, 10});
  }
  std::optional<Order> fail(const std::string& worker, const OrderStart& job, FailureClass kind) {
    return report(worker, WorkerFinished{job.job, job.token, JobFailure{kind, "no luck"}, "", 0, 0});
  }
  void pass(Millis time) {
    now += time;
    Effects effects;
    queue.tick(now, effects);
    tables.apply(effects);
  }
  template <class Call>
  void apply(Call call) {
    Effects effects;
    call(effects);
    tables.apply(effects);
  }
  JobState state(const StageSpec& spec) const { return queue.find_key(stage_key(spec))->status.state; }
  std::string detail(const StageSpec& spec) const { return queue.find_key(stage_key(spec))->status.detail; }
  ~Lab() { EXPECT_TRUE(tables.breaches.empty()) << tables.breaches.front(); }
};

bool drops(const std::optional<Order>& order) { return order && std::holds_alternative<OrderDrop>(*order); }

TEST(JobQueue, GivesTheBedFirstAndThenWhatStandsOnIt) {
  Lab lab;
  lab.submit(study(1));
  const OrderStart settle = lab.start("a");
  EXPECT_EQ(settle.spec.kind, StageKind::kSettle);
  EXPECT_FALSE(lab.report("b", WorkerIdle{})) << "nothing else is ready before the bed is";
  const auto next = lab.finish("a", settle);
  ASSERT_TRUE(next && std::holds_alternative<OrderStart>(*next)) << "report and next assignment travel in one call";
  EXPECT_EQ(std::get<OrderStart>(*next).bed, "bed");
}

TEST(JobQueue, EndsTheExperimentWhenAllItsJobsHaveEnded) {
  Lab lab;
  const ExperimentId id = lab.submit(study(2));
  for (auto order = lab.report("a", WorkerIdle{}); order;) order = lab.finish("a", std::get<OrderStart>(*order));
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kDone);
  EXPECT_EQ(lab.tables.studies.at(id).events.back().kind, EventKind::kEnded);
  EXPECT_EQ(lab.tables.results.size(), 10U);
}

TEST(JobQueue, ARepeatedReportGetsTheRememberedAnswer) {
  Lab lab;
  lab.submit(study(2));
  Effects effects;
  const WorkerReport report{"a", 1, false, WorkerIdle{}};
  const auto first = lab.queue.exchange(report, 0, effects);
  const std::size_t written = effects.size();
  const auto second = lab.queue.exchange(report, 5, effects);
  lab.tables.apply(effects);
  EXPECT_EQ(std::get<OrderStart>(*first).token, std::get<OrderStart>(*second).token);
  EXPECT_EQ(effects.size(), written);
}

TEST(JobQueue, AnIdleWorkerWithALeaseIsToldItsJobAgain) {
  Lab lab;
  lab.submit(study(2));
  const OrderStart first = lab.start("a");
  const OrderStart again = lab.start("a");
  EXPECT_EQ(first.token, again.token);
}

TEST(JobQueue, ALateResultFromAnExpiredLeaseIsRefused) {
  Lab lab;
  lab.submit(study(1));
  const OrderStart old = lab.start("slow");
  lab.pass(lab.policy.lease_ttl);
  const OrderStart fresh = lab.start("quick");
  EXPECT_EQ(fresh.job, old.job);
  EXPECT_GT(fresh.token, old.token);
  EXPECT_TRUE(drops(lab.finish("slow", old)));
  EXPECT_TRUE(lab.tables.results.empty());
  lab.finish("quick", fresh);
  EXPECT_EQ(lab.tables.results.size(), 1U);
}

TEST(JobQueue, HeartbeatsKeepALeaseAlive) {
  Lab lab;
  lab.submit(study(1));
  const OrderStart job = lab.start("a");
  for (int i = 0; i < 10; ++i) {
    lab.pass(lab.policy.lease_ttl - 1);
    EXPECT_FALSE(lab.report("a", WorkerRunning{job.job, job.token, {"shear", 0.1 * i, 100, 1e6}, ""}));
  }
  EXPECT_TRUE(std::holds_alternative<OrderStart>(*lab.finish("a", job)));
}

TEST(JobQueue, TransientFailuresAreRetriedAfterGrowingPausesAndThenFail) {
  Lab lab;
  const ExperimentId id = lab.submit(study(1));
  Millis last = 0;
  for (int attempt = 1; attempt < lab.policy.max_attempts; ++attempt) {
    lab.fail("a", lab.start("a"), FailureClass::kTransient);
    EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kBackoff);
    const Millis began = lab.now;
    while (lab.state(stage(StageKind::kSettle, 1)) == JobState::kBackoff) lab.pass(10);
    EXPECT_GT(lab.now - began, last);
    last = lab.now - began;
  }
  lab.fail("a", lab.start("a"), FailureClass::kTransient);
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kFailed);
  EXPECT_EQ(lab.state(stage(StageKind::kRepose, 1)), JobState::kSkipped);
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kFailed);
}

TEST(JobQueue, PermanentFailuresFailAtOnceAndPreemptionIsNotCounted) {
  Lab lab;
  lab.submit(study(2));
  for (int i = 0; i < 20; ++i)
    lab.report("a", WorkerFinished{lab.start("a").job, lab.queue.last_token(),
                                   JobFailure{FailureClass::kPreempted, "told to stop"}, "", 0, 0});
  EXPECT_NE(lab.state(stage(StageKind::kSettle, 1)), JobState::kFailed);
  lab.fail("a", lab.start("a"), FailureClass::kPermanent);
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kFailed);
}

TEST(JobQueue, AJobThatKillsItsWorkersAtTheSamePlaceIsQuarantined) {
  Lab lab;
  lab.submit(study(1));
  for (int i = 0; i < 3; ++i) {
    const OrderStart job = lab.start("w" + std::to_string(i));
    lab.report("w" + std::to_string(i), WorkerRunning{job.job, job.token, {"settle", 0.5, 5000, 1e6}, ""});
    lab.pass(lab.policy.lease_ttl);
  }
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kQuarantined);
  EXPECT_EQ(lab.state(stage(StageKind::kStress, 1, 1250)), JobState::kSkipped);
  EXPECT_NE(lab.detail(stage(StageKind::kStress, 1, 1250)).find("3 workers died"), std::string::npos);
}

TEST(JobQueue, AJobThatKillsItsWorkersBeforeTheySpeakIsQuarantinedLater) {
  Lab lab;
  lab.submit(study(1));
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kReady);
    lab.start("w" + std::to_string(i));
    lab.pass(lab.policy.lease_ttl);
  }
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kQuarantined);
}

TEST(JobQueue, WorkersKilledAtOtherPlacesDoNotQuarantineTheirJob) {
  Lab lab;
  lab.submit(study(1));
  for (std::uint64_t i = 0; i < 10; ++i) {
    const std::string name = "w" + std::to_string(i);
    const OrderStart job = lab.start(name);
    const std::uint64_t base = 10'000 * (i % 5 + 1);
    lab.report(name, WorkerRunning{job.job, job.token, {"settle", 0.5, base, 1e6}, ""});
    lab.report(name, WorkerRunning{job.job, job.token, {"settle", 0.5, base + 1000, 1e6}, ""});
    lab.pass(lab.policy.lease_ttl);
  }
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kReady);
}

TEST(JobQueue, ExpiriesWhileTheSchedulerWasDownDoNotCount) {
  Lab lab;
  lab.submit(study(1));
  for (int i = 0; i < 10; ++i) {
    lab.start("w" + std::to_string(i));
    lab.queue = lab.tables.load(lab.policy, lab.queue.last_token(), lab.now);
    lab.pass(lab.policy.lease_ttl);
  }
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kReady);
}

TEST(JobQueue, AFinishedResultIsTakenAfterTheSchedulerWasDown) {
  Lab lab;
  lab.submit(study(1));
  const OrderStart job = lab.start("a");
  lab.now += 100 * lab.policy.lease_ttl;
  lab.queue = lab.tables.load(lab.policy, lab.queue.last_token(), lab.now);
  EXPECT_TRUE(std::holds_alternative<OrderStart>(*lab.finish("a", job)));
  EXPECT_EQ(lab.tables.results.size(), 1U);
}

TEST(JobQueue, TheNewestCheckpointGoesToTheNextHolder) {
  Lab lab;
  lab.submit(study(1));
  const OrderStart job = lab.start("a");
  lab.report("a", WorkerRunning{job.job, job.token, {"settle", 0.5, 1, 1}, "first"});
  lab.report("a", WorkerRunning{job.job, job.token, {"settle", 0.6, 2, 1}, "second"});
  lab.pass(lab.policy.lease_ttl);
  lab.queue = lab.tables.load(lab.policy, lab.queue.last_token(), lab.now);
  EXPECT_EQ(lab.start("b").checkpoint, "second");
}

TEST(JobQueue, AnUnphysicalEndIsAResultAndLeavesNoBed) {
  Lab lab;
  const ExperimentId id = lab.submit(study(1));
  lab.finish("a", lab.start("a"), StageEnd::kNotSettled);
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kSucceeded);
  EXPECT_EQ(lab.detail(stage(StageKind::kFabric, 1)), "no bed to start from (settling ended as not_settled: it did not)");
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kDone);
}

TEST(JobQueue, BedsAndResultsAreSharedAcrossExperiments) {
  Lab lab;
  const ExperimentId one = lab.submit(study(2));
  const ExperimentId two = lab.submit(study(3));  // points 1 and 2 are the same stages
  EXPECT_EQ(lab.tables.jobs.size(), 15U);
  for (auto order = lab.report("a", WorkerIdle{}); order;) order = lab.finish("a", std::get<OrderStart>(*order));
  EXPECT_EQ(lab.queue.find(one)->state, ExperimentState::kDone);
  EXPECT_EQ(lab.queue.find(two)->state, ExperimentState::kDone);
  const ExperimentId three = lab.submit(study(3));
  EXPECT_EQ(lab.queue.find(three)->state, ExperimentState::kDone) << "everything was stored already";
  EXPECT_TRUE(lab.tables.links.back().reused);
}

TEST(JobQueue, CancelStopsOnlyWhatNobodyElseNeeds) {
  Lab lab;
  lab.submit(study(1));
  const ExperimentId two = lab.submit(study(2));
  lab.start("a");                         // point 1, shared
  const OrderStart own = lab.start("b");  // point 2, of `two` alone
  lab.apply([&](Effects& e) { lab.queue.cancel(two, lab.now, e); });
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kLeased);
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 2)), JobState::kCancelled);
  EXPECT_TRUE(drops(lab.finish("b", own)));
  EXPECT_TRUE(lab.tables.results.empty()) << "nothing commits after the cancel";
}

TEST(JobQueue, RetryBringsBackWhatFailedWasCancelledOrSkipped) {
  Lab lab;
  const ExperimentId id = lab.submit(study(1));
  lab.fail("a", lab.start("a"), FailureClass::kPermanent);
  lab.apply([&](Effects& e) { lab.queue.retry(id, lab.now, e); });
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kRunning);
  lab.apply([&](Effects& e) { lab.queue.cancel(id, lab.now, e); });
  lab.apply([&](Effects& e) { lab.queue.retry(id, lab.now, e); });
  for (auto order = lab.report("b", WorkerIdle{}); order;) order = lab.finish("b", std::get<OrderStart>(*order));
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kDone);
}

TEST(JobQueue, ALostBedIsMadeAgainBeforeWhatNeedsIt) {
  Lab lab;
  const ExperimentId id = lab.submit(study(1));
  lab.finish("a", lab.start("a"));
  lab.apply([&](Effects& e) { lab.queue.bed_lost("bed", lab.now, e); });
  EXPECT_EQ(lab.state(stage(StageKind::kSettle, 1)), JobState::kReady);
  EXPECT_EQ(lab.state(stage(StageKind::kFabric, 1)), JobState::kBlocked);
  for (auto order = lab.report("b", WorkerIdle{}); order;) order = lab.finish("b", std::get<OrderStart>(*order));
  EXPECT_EQ(lab.queue.find(id)->state, ExperimentState::kDone);
}

TEST(JobQueue, ADrainingWorkerIsSentAway) {
  Lab lab;
  lab.submit(study(1));
  const auto order = lab.report("a", WorkerIdle{}, true);
  EXPECT_TRUE(order && std::holds_alternative<OrderLeave>(*order));
}

}  // namespace
}  // namespace regolab
