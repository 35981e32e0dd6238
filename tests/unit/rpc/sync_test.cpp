/// The worker's protocol by hand: orders, reports, uploads, and what is refused.
#include <fstream>

#include "digest/sha256.h"
#include "rpc/convert.h"
#include "unit/rpc/service_fixture.h"

namespace regolab {
namespace {

using test::FakeStage;
using test::l4_yaml;
using testing::HasSubstr;

/// A worker played by hand, report by report. No lease runs out in an hour, so nothing here depends on how fast the machine
/// is.
struct SyncTest : test::ServiceTest {
  SyncTest() : ServiceTest(3'600'000) {}

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

TEST_F(SyncTest, AnIdleWorkerIsAnsweredWhenWorkArrives) {
  auto request = idle("a", 1);
  request.set_hold_ms(20'000);
  std::jthread submitter([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    client->submit(l4_yaml(1));
  });
  EXPECT_TRUE(sync(request).has_start());
}

TEST_F(SyncTest, ARepeatedSyncGetsTheSameOrder) {
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

TEST_F(SyncTest, ADoubledReportCommitsOnce) {
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

TEST_F(SyncTest, ABedMustBeStoredBeforeItsReport) {
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

TEST_F(SyncTest, ADamagedBedIsMadeAgain) {
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

TEST_F(SyncTest, WrongUploadsAndStrangeWorkersAreRefused) {
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

}  // namespace
}  // namespace regolab
