/// Server, store and worker sessions in one process, over a real socket.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "digest/sha256.h"
#include "scheduler/gap/bank.h"
#include "rpc/convert.h"
#include "scheduler/rpc/server.h"
#include "store/database.h"
#include "support/fake_stage.h"
#include "support/lab_client.h"
#include "support/temp_dir.h"
#include "worker/rpc/session.h"

namespace regolab {
namespace {

using test::FakeStage;
using test::l4_yaml;
using test::LabClient;
using testing::HasSubstr;

struct ServiceTest : testing::Test {
  test::TempDir dir;
  QueuePolicy policy{.lease_ttl = 1000, .first_backoff = 20, .longest_backoff = 100};
  std::unique_ptr<Server> server;
  std::unique_ptr<LabClient> client;

  ServiceTest() { start(); }
  void start() {
    auto started = Server::start(
        {dir / "lab.db", "unix:" + (dir / "socket"), policy, [](const Error& error) { FAIL() << error.text; }});
    ASSERT_TRUE(started.ok()) << started.error().text;
    server = std::move(*started);
    client = std::make_unique<LabClient>(server->address());
  }
  void restart() {
    server.reset();
    start();
  }

  /// A worker in a thread of this process; leaves when the object goes.
  struct Worker {
    Worker(const ServiceTest& test, const std::string& name, FakeStage stage)
        : session(
              {.server = "unix:" + (test.dir / "socket"), .name = name, .stage = {.threads = 1, .checkpoint_every_s = 0.05}},
              stage),
          thread([this] { session.run(); }) {}
    ~Worker() { session.leave(); }
    Session session;
    std::jthread thread;
  };
  v1::SyncReply sync(v1::SyncRequest request) {
    request.set_physics_version(kPhysicsVersion);
    v1::SyncReply reply;
    grpc::ClientContext context;
    const auto status = client->pool->Sync(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply;
  }
  v1::SyncRequest idle(const std::string& worker, std::uint64_t seq) {
    v1::SyncRequest request;
    request.set_worker(worker);
    request.set_seq(seq);
    request.mutable_slot()->mutable_idle();
    return request;
  }
  std::string upload(const std::string& bytes, const std::string& digest, grpc::Status* status) {
    grpc::ClientContext context;
    v1::UploadReply reply;
    const auto writer = client->artifacts->Upload(&context, &reply);
    v1::Chunk chunk;
    chunk.set_digest(digest);
    chunk.set_data(bytes);
    writer->Write(chunk);
    writer->WritesDone();
    *status = writer->Finish();
    return reply.digest();
  }
};

TEST_F(ServiceTest, AStudyRunsFromSubmissionToTable) {
  const auto submitted = client->submit(l4_yaml(2));
  EXPECT_EQ(submitted.summary().jobs(), 40U);
  EXPECT_EQ(submitted.summary().dem_jobs(), 32U);
  const Worker a{*this, "a", {.duration_s = 0.02}}, b{*this, "b", {.duration_s = 0.02}};
  const auto events = client->watch(submitted.experiment());
  std::uint64_t last = 0;
  std::vector<std::string> texts;
  for (const auto& event : events) {
    if (event.progress_only()) continue;
    EXPECT_EQ(event.seq(), last + 1);
    last = event.seq();
    texts.push_back(event.text());
  }
  EXPECT_EQ(last, 42U) << "submitted, 40 stages, ended";
  EXPECT_EQ(texts.front(), "submitted");
  EXPECT_EQ(texts.back(), "done");
  EXPECT_THAT(texts, testing::Contains(HasSubstr("repose: ")));
  const auto status = client->status(submitted.experiment());
  EXPECT_EQ(status.state(), "done");
  EXPECT_EQ(status.jobs().succeeded(), 40U);
  EXPECT_EQ(status.summary().array(), submitted.summary().array());
  const auto table = client->table(submitted.experiment());
  ASSERT_EQ(table.rows_size(), 8);
  EXPECT_TRUE(table.rows(0).value_si().contains("repose_angle"));
  EXPECT_TRUE(table.rows(0).value_si().contains("sigma1_at_sigma3_2.5kPa"));
  auto db = Database::open(dir / "lab.db", Access::kRead);  // the views, as pandas and R read them
  const auto number = [&](const char* sql) {
    Statement s = db->prepare(sql);
    return s.step() ? s.real(0) : -1;
  };
  EXPECT_EQ(number("SELECT count(*) FROM responses_wide"), 8);
  EXPECT_EQ(number("SELECT repose_angle_rad FROM responses_wide WHERE point = 1 AND seed = 1"),
            table.rows(0).value_si().at("repose_angle"));
  EXPECT_EQ(number("SELECT sigma1_pa FROM strength WHERE point = 1 AND seed = 1 AND sigma3_pa = 2500"),
            table.rows(0).value_si().at("sigma1_at_sigma3_2.5kPa"));
  EXPECT_EQ(number("SELECT count(*) FROM factors WHERE factor = 'theta_F' AND level = '5'"), 2);
  EXPECT_EQ(number("SELECT count(*) FROM stages WHERE state = 'succeeded' AND stage_end = 'completed'"), 40);
  EXPECT_EQ(number("SELECT count(DISTINCT sigma3_pa) FROM curves"), 2);
  v1::RangeRequest request;
  request.set_experiment(submitted.experiment());
  request.set_response("repose_angle");
  v1::RangeReply range;
  grpc::ClientContext context;
  ASSERT_TRUE(client->results->Range(&context, request, &range).ok());
  EXPECT_EQ(range.responses(0).factors(0).rank(), 1) << "the fake repose angle follows theta_F";
}

TEST_F(ServiceTest, ABankHasARowForEachPointAndSeed) {
  const auto submitted = client->submit(l4_yaml(2));
  {
    const Worker worker{*this, "w", {.duration_s = 0.02}};
    client->wait(submitted.experiment());
  }
  v1::BankRequest request;
  request.add_experiments(submitted.experiment());
  v1::BankReply reply;
  const auto status = client->call(*client->gaps, &v1::Gaps::Stub::Bank, request, &reply);
  ASSERT_TRUE(status.ok()) << status.error_message();
  EXPECT_EQ(reply.rows(), 8U);
  const auto bank = gap::read_bank("bank.csv", reply.csv());
  ASSERT_TRUE(bank.ok()) << to_text(bank.diagnostics.front());
  ASSERT_EQ(bank.value->rows.size(), 8U);
  ASSERT_TRUE(bank.value->input("theta_F") && bank.value->input("N_E") && bank.value->feature("sigma1_ratio_2.5"));
  for (const auto& row : bank.value->rows) {
    const double friction = row.inputs[*bank.value->input("theta_F")];
    EXPECT_NEAR(row.features[*bank.value->feature("repose_angle")], friction, 0.011) << "the fake measures theta_F as its slope";
    EXPECT_EQ(row.inputs[*bank.value->input("particles")], 120);
    const double ratio = std::exp(row.features[*bank.value->feature("sigma1_ratio_2.5")]);
    EXPECT_TRUE(ratio > 2 && ratio < 3) << ratio;
  }
  request.add_experiments("none");
  EXPECT_EQ(client->call(*client->gaps, &v1::Gaps::Stub::Bank, request, &reply).error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(ServiceTest, MeasurementsAreReadOrRefusedWithTheirPlaces) {
  v1::ImportRequest request;
  request.set_file_name("o.yaml");
  request.set_content("format: observations/1\ncase: c\nobservables:\n- {id: bulk_density, value: 1.6, unit: g/cm3, standard_error: 0.016}\n");
  request.set_want_file(true);
  v1::ImportReply reply;
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.features_size(), 1);
  EXPECT_EQ(reply.features(0).unit(), "g/cm3");
  EXPECT_NEAR(reply.features(0).shown(), 1.6, 1e-12);
  EXPECT_NEAR(reply.features(0).value(), 1600, 1e-9);
  EXPECT_TRUE(reply.few());
  EXPECT_THAT(reply.file(), HasSubstr("observations/1"));

  request.set_content("format: observations/1\ncase: c\nobservables:\n- {id: bulk_density, value: 1.6, unit: kPa, standard_error: -1}\n");
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.diagnostics_size(), 2);
  EXPECT_EQ(reply.diagnostics(0).line(), 4U);

  request.set_content(std::string((16 << 20) + 1, '#'));
  ASSERT_TRUE(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).ok());
  ASSERT_EQ(reply.diagnostics_size(), 1);
  EXPECT_THAT(reply.diagnostics(0).text(), HasSubstr("the limit is 16777216"));
  request.set_content(std::string(19 << 20, '#'));
  EXPECT_EQ(client->call(*client->gaps, &v1::Gaps::Stub::Import, request, &reply).error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
}

TEST_F(ServiceTest, TheSameStudyAgainRunsNothing) {
  const auto first = client->submit(l4_yaml(1));
  {
    const Worker a{*this, "a", {.duration_s = 0}};
    EXPECT_EQ(client->wait(first.experiment()).state(), "done");
  }
  const auto again = client->submit(l4_yaml(1), "another request");
  EXPECT_TRUE(again.already_known());
  EXPECT_EQ(again.experiment(), first.experiment());
  EXPECT_EQ(again.summary().dem_jobs(), 0U);
  const auto renamed = client->submit(l4_yaml(1, "five points"));
  EXPECT_FALSE(renamed.already_known());
  const auto status = client->wait(renamed.experiment());
  EXPECT_EQ(status.state(), "done") << "with nobody to work";
  EXPECT_EQ(status.jobs().reused(), 20U);
  const auto larger = client->submit(l4_yaml(2));
  EXPECT_EQ(larger.summary().jobs_stored(), 20U);
  EXPECT_EQ(larger.summary().dem_jobs(), 16U);
}

TEST_F(ServiceTest, AStudyAtAnotherGravityIsNotComparedWithTheArticle) {
  std::string design = l4_yaml(1);
  design.insert(design.find("fixed:\n") + 7, "  gravity: 9.8 m/s2\n");
  const auto submitted = client->submit(design);
  ASSERT_FALSE(submitted.experiment().empty());
  v1::CompareArticleRequest request;
  request.set_experiment(submitted.experiment());
  v1::CompareArticleReply reply;
  grpc::ClientContext context;
  const auto status = client->results->CompareArticle(&context, request, &reply);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_THAT(status.error_message(), HasSubstr("gravity 9.8 m/s2 (the article has 1.63 m/s2)"));
}

TEST_F(ServiceTest, ARepeatedRequestIdIsTheSameExperiment) {
  const auto first = client->submit(l4_yaml(1), "mine");
  const auto again = client->submit(l4_yaml(1), "mine");  // as after a lost answer
  EXPECT_EQ(first.experiment(), again.experiment());
  v1::SubmitRequest other;
  other.set_request_id("mine");
  other.set_design_yaml(l4_yaml(3));
  v1::SubmitReply reply;
  grpc::ClientContext context;
  const auto status = client->experiments->Submit(&context, other, &reply);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::ALREADY_EXISTS) << status.error_message();
}

TEST_F(ServiceTest, ABadDesignIsRefusedWithItsPlacesAndNothingIsStored) {
  v1::SubmitRequest request;
  request.set_file_name("bad.yaml");
  request.set_design_yaml(l4_yaml(1) + "surprise: 3\n");
  v1::SubmitReply reply;
  grpc::ClientContext context;
  ASSERT_TRUE(client->experiments->Submit(&context, request, &reply).ok());
  ASSERT_EQ(reply.diagnostics_size(), 1);
  EXPECT_EQ(reply.diagnostics(0).file(), "bad.yaml");
  EXPECT_GT(reply.diagnostics(0).line(), 0U);
  EXPECT_TRUE(reply.experiment().empty());
  v1::ListReply list;
  grpc::ClientContext list_context;
  ASSERT_TRUE(client->experiments->List(&list_context, {}, &list).ok());
  EXPECT_EQ(list.experiments_size(), 0);
}

TEST_F(ServiceTest, AWorkerOutlivesItsSchedulerAndDeliversThen) {
  const auto submitted = client->submit(l4_yaml(1));
  const Worker a{*this, "a", {.duration_s = 0.15}}, b{*this, "b", {.duration_s = 0.15}};
  while (client->status(submitted.experiment()).running_size() == 0) std::this_thread::yield();
  server.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // the stages end while nobody listens
  start();
  const auto status = client->wait(submitted.experiment());
  EXPECT_EQ(status.state(), "done");
}

TEST_F(ServiceTest, ALeavingWorkerHandsItsCheckpointToTheNext) {
  const auto undisturbed = client->submit(l4_yaml(1));
  {
    const Worker a{*this, "a", {.duration_s = 0.02}};
    client->wait(undisturbed.experiment());
  }
  const auto expected = client->results_by_key(undisturbed.experiment());
  server.reset();
  std::filesystem::remove_all(dir / "lab.db.d");
  for (const char* name : {"lab.db", "lab.db-wal", "lab.db-shm"}) std::filesystem::remove(dir / name);
  start();
  const auto disturbed = client->submit(l4_yaml(1));
  std::atomic<int> resumed = 0;
  const FakeStage fake{.duration_s = 0.15};
  for (int i = 0; client->status(disturbed.experiment()).state() == "running"; ++i) {
    Session session(
        {.server = server->address(), .name = "w" + std::to_string(i), .stage = {.threads = 1, .checkpoint_every_s = 0.05}},
        [&](const StageSpec& spec, const std::string& bed, const std::string& checkpoint, const StageHooks& hooks) {
          if (!checkpoint.empty()) ++resumed;
          return fake(spec, bed, checkpoint, hooks);
        });
    std::jthread thread([&] { session.run(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(220));
    session.leave();
  }
  EXPECT_GT(resumed, 2);
  EXPECT_EQ(client->results_by_key(disturbed.experiment()), expected) << "bit-equal to the undisturbed run";
}

TEST_F(ServiceTest, CancelStopsTheRunningStageAtOnce) {
  const auto submitted = client->submit(l4_yaml(1));
  const Worker a{*this, "a", {.duration_s = 30}};
  while (client->status(submitted.experiment()).running_size() == 0) std::this_thread::yield();
  v1::CancelRequest request;
  request.set_experiment(submitted.experiment());
  v1::ExperimentStatus status;
  grpc::ClientContext context;
  ASSERT_TRUE(client->experiments->Cancel(&context, request, &status).ok());
  EXPECT_EQ(status.state(), "cancelled");
  EXPECT_EQ(status.jobs().cancelled(), 20U);
  const auto table = client->table(submitted.experiment());
  EXPECT_EQ(table.rows(0).missing().at("repose_angle"), "cancelled");
  const auto next = client->submit(l4_yaml(1, "next", "numerics: {step_fraction: 0.1}\n"));
  const auto began = std::chrono::steady_clock::now();
  while (client->status(next.experiment()).running_size() == 0) std::this_thread::yield();
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10)) << "the worker was not let go";
  const auto back = client->submit(l4_yaml(1));  // the cancelled study again: goes on
  EXPECT_TRUE(back.already_known());
  EXPECT_EQ(client->status(submitted.experiment()).state(), "running");
}

TEST_F(ServiceTest, UnphysicalAndFailedStagesAreSaidNotHidden) {
  const auto submitted = client->submit(l4_yaml(2));
  const Worker a{*this, "a", {.duration_s = 0, .broken_seed = 2, .restless_seed = 1}};
  const auto status = client->wait(submitted.experiment());
  EXPECT_EQ(status.state(), "failed");
  EXPECT_EQ(status.jobs().unphysical(), 4U);
  EXPECT_EQ(status.jobs().skipped(), 16U);
  EXPECT_EQ(status.jobs().failed(), 4U);
  EXPECT_THAT(status.failures(), testing::Contains(HasSubstr("not_settled (time limit before rest")));
  EXPECT_THAT(status.failures(), testing::Contains(HasSubstr("failed (made to fail")));
  const auto table = client->table(submitted.experiment());
  for (const auto& row : table.rows()) {
    const char* why = row.seed() == 1 ? "settling ended as not_settled" : "failed: made to fail";
    EXPECT_THAT(row.missing().at("bulk_density"), HasSubstr(why));
  }
}

TEST_F(ServiceTest, AnIdleWorkerIsAnsweredWhenWorkArrives) {
  auto request = idle("a", 1);
  request.set_hold_ms(20'000);
  std::jthread submitter([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    client->submit(l4_yaml(1));
  });
  EXPECT_TRUE(sync(request).has_start());
}

TEST_F(ServiceTest, ARepeatedSyncGetsTheSameOrder) {
  client->submit(l4_yaml(1));
  const auto first = sync(idle("a", 1));
  const auto again = sync(idle("a", 1));
  ASSERT_TRUE(first.has_start());
  EXPECT_EQ(first.start().lease_token(), again.start().lease_token());
  restart();
  const auto later = sync(idle("a", 1));  // the memory of answers is gone, the lease is not
  EXPECT_EQ(later.start().lease_token(), first.start().lease_token());
  EXPECT_NE(sync(idle("b", 1)).start().job(), first.start().job());
}

TEST_F(ServiceTest, ADoubledReportCommitsOnce) {
  const auto submitted = client->submit(l4_yaml(1));
  const auto order = sync(idle("a", 1));
  const StageSpec spec = *from_proto(order.start().spec());
  const auto output = FakeStage{.duration_s = 0}(spec, "", "", {});
  grpc::Status status;
  upload(output->bed, sha256_hex(output->bed), &status);
  ASSERT_TRUE(status.ok()) << status.error_message();
  v1::SyncRequest report;
  report.set_worker("a");
  report.set_seq(2);
  auto& finished = *report.mutable_slot()->mutable_finished();
  finished.set_job(order.start().job());
  finished.set_lease_token(order.start().lease_token());
  *finished.mutable_result() = to_proto(output->result);
  finished.set_bed(sha256_hex(output->bed));
  const auto first = sync(report);
  const auto again = sync(report);
  ASSERT_TRUE(first.has_start());
  EXPECT_EQ(first.start().lease_token(), again.start().lease_token());
  restart();
  report.set_seq(3);
  EXPECT_TRUE(sync(report).has_start()) << "accepted before the restart, so the worker just gets its order again";
  EXPECT_EQ(client->status(submitted.experiment()).jobs().succeeded(), 1U);
}

TEST_F(ServiceTest, ABedMustBeStoredBeforeItsReport) {
  client->submit(l4_yaml(1));
  const auto order = sync(idle("a", 1));
  v1::SyncRequest report;
  report.set_worker("a");
  report.set_seq(2);
  report.set_physics_version(kPhysicsVersion);
  auto& finished = *report.mutable_slot()->mutable_finished();
  finished.set_job(order.start().job());
  finished.set_lease_token(order.start().lease_token());
  finished.mutable_result();
  finished.set_bed(sha256_hex("never sent"));
  v1::SyncReply reply;
  grpc::ClientContext context;
  const auto status = client->pool->Sync(&context, report, &reply);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_THAT(status.error_message(), HasSubstr("upload it before reporting"));
}

TEST_F(ServiceTest, ADamagedBedIsMadeAgain) {
  const auto submitted = client->submit(l4_yaml(1));
  std::string bed;
  {
    const auto order = sync(idle("a", 1));
    const auto output = FakeStage{.duration_s = 0}(*from_proto(order.start().spec()), "", "", {});
    grpc::Status status;
    bed = upload(output->bed, sha256_hex(output->bed), &status);
    v1::SyncRequest report;
    report.set_worker("a");
    report.set_seq(2);
    report.set_draining(true);
    auto& finished = *report.mutable_slot()->mutable_finished();
    finished.set_job(order.start().job());
    finished.set_lease_token(order.start().lease_token());
    *finished.mutable_result() = to_proto(output->result);
    finished.set_bed(bed);
    EXPECT_TRUE(sync(report).has_leave());
  }
  std::ofstream(dir / ("lab.db.d/cas/" + bed.substr(0, 2) + "/" + bed.substr(2))) << "bits rot";
  const Worker a{*this, "b", {.duration_s = 0}};
  const auto status = client->wait(submitted.experiment());
  EXPECT_EQ(status.state(), "done");
  EXPECT_EQ(status.jobs().succeeded(), 20U);
}

TEST_F(ServiceTest, WrongUploadsAndStrangeWorkersAreRefused) {
  grpc::Status status;
  upload("bytes", sha256_hex("others"), &status);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DATA_LOSS);
  upload("bytes", "../../etc/passwd", &status);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  v1::SyncRequest request = idle("a", 1);
  request.set_physics_version(kPhysicsVersion + 1);
  v1::SyncReply reply;
  grpc::ClientContext context;
  const auto refused = client->pool->Sync(&context, request, &reply);
  EXPECT_EQ(refused.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_THAT(refused.error_message(), HasSubstr("use worker and scheduler of one build"));
  request = idle("", 1);
  request.set_physics_version(kPhysicsVersion);
  grpc::ClientContext second;
  EXPECT_EQ(client->pool->Sync(&second, request, &reply).error_code(), grpc::StatusCode::INVALID_ARGUMENT);
}

TEST_F(ServiceTest, AWatchGoesOnWhereItBroke) {
  const auto submitted = client->submit(l4_yaml(1));
  {
    const Worker a{*this, "a", {.duration_s = 0}};
    client->wait(submitted.experiment());
  }
  restart();
  const auto events = client->watch(submitted.experiment(), 10);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front().seq(), 10U);
  EXPECT_EQ(events.back().seq(), 22U);
  const auto nothing_new = client->watch(submitted.experiment(), 23);
  ASSERT_EQ(nothing_new.size(), 1U);
  EXPECT_TRUE(nothing_new[0].progress_only());
  EXPECT_EQ(nothing_new[0].status().state(), "done");
  grpc::ClientContext context;
  v1::WatchRequest request;
  request.set_experiment("none");
  const auto reader = client->experiments->Watch(&context, request);
  v1::WatchEvent event;
  EXPECT_FALSE(reader->Read(&event));
  EXPECT_EQ(reader->Finish().error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(ServiceTest, TheRemainingTimeIsKnownOnceEveryKindWasMeasured) {
  const auto first = client->submit(l4_yaml(1));
  EXPECT_LT(client->status(first.experiment()).remaining_s(), 0);
  {
    const Worker a{*this, "a", {.duration_s = 0.02}};
    client->wait(first.experiment());
  }
  const auto second = client->submit(l4_yaml(2));
  const Worker b{*this, "b", {.duration_s = 0.05}};
  while (client->status(second.experiment()).workers() == 0) std::this_thread::yield();
  EXPECT_GT(client->status(second.experiment()).remaining_s(), 0);
  client->wait(second.experiment());
}

TEST_F(ServiceTest, ASecondServerOnTheSameAddressOrFileIsRefused) {
  const auto same_file = Server::start({dir / "lab.db", "unix:" + (dir / "other"), policy, {}});
  EXPECT_THAT(same_file.error().text, HasSubstr("the database is in use"));
  const auto same_address = Server::start({dir / "other.db", "unix:" + (dir / "socket"), policy, {}});
  EXPECT_EQ(same_address.error().code, Code::kAlreadyExists);
  EXPECT_THAT(same_address.error().text, HasSubstr("the address is in use"));
  EXPECT_FALSE(std::filesystem::exists(dir / "other.db")) << "nothing is left of a start that failed";
}

}  // namespace
}  // namespace regolab
