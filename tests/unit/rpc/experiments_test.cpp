/// From submission to table: what a client sees of its studies.
#include <filesystem>

#include "store/database.h"
#include "unit/rpc/service_fixture.h"

namespace regolab {
namespace {

using ServiceTest = test::ServiceTest;
using test::l4_yaml;
using testing::HasSubstr;

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
