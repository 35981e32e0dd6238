/// A scheduler that answers what the test told it to, on a socket of its own.
#pragma once
#include <grpcpp/grpcpp.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "regolab/v1/lab.grpc.pb.h"
#include "tests/unit/client/fake_blind.h"

namespace regolab::client {

class FakeLab : public v1::Experiments::Service, public v1::Results::Service {
 public:
  FakeLab();
  ~FakeLab() override;
  const std::string& address() const { return address_; }

  // What it answers. Set before calls are made.
  v1::SubmitReply judged;
  v1::SubmitReply submitted;
  std::vector<v1::ExperimentStatus> experiments;
  v1::ExperimentStatus final_status;
  std::vector<v1::WatchEvent> events;  ///< sent from the seq asked for
  int break_after = -1;                ///< the stream breaks once after so many events; -1 = never
  v1::ResultsReply results;
  v1::RangeReply range;
  v1::CheckArticleReply check;
  v1::CompareArticleReply comparison;
  v1::TrainFunctionsReply functions;
  std::vector<v1::ExportItem> items;
  FakeBlind blind;
  grpc::Status refusal = grpc::Status::OK;  ///< of GetResults, Range, CompareArticle and TrainFunctions

  // What it was asked.
  std::vector<std::uint64_t> watched_from();
  std::vector<v1::SubmitRequest> submissions();
  std::string last_cancelled();
  v1::TrainFunctionsRequest last_training();

 private:
  using Context = grpc::ServerContext;
  using Status = grpc::Status;
  Status Validate(Context*, const v1::SubmitRequest* in, v1::SubmitReply* out) override;
  Status Submit(Context*, const v1::SubmitRequest* in, v1::SubmitReply* out) override;
  Status List(Context*, const v1::ListRequest* in, v1::ListReply* out) override;
  Status Get(Context*, const v1::GetRequest* in, v1::ExperimentStatus* out) override;
  Status Watch(Context*, const v1::WatchRequest* in, grpc::ServerWriter<v1::WatchEvent>* out) override;
  Status Cancel(Context*, const v1::CancelRequest* in, v1::ExperimentStatus* out) override;
  Status Retry(Context*, const v1::RetryRequest* in, v1::ExperimentStatus* out) override;
  Status GetResults(Context*, const v1::ResultsRequest* in, v1::ResultsReply* out) override;
  Status Range(Context*, const v1::RangeRequest* in, v1::RangeReply* out) override;
  Status CheckArticle(Context*, const v1::CheckArticleRequest* in, v1::CheckArticleReply* out) override;
  Status CompareArticle(Context*, const v1::CompareArticleRequest* in, v1::CompareArticleReply* out) override;
  Status TrainFunctions(Context*, const v1::TrainFunctionsRequest* in, v1::TrainFunctionsReply* out) override;
  Status Export(Context*, const v1::ExportRequest* in, grpc::ServerWriter<v1::ExportItem>* out) override;

  std::filesystem::path folder_;
  std::string address_;
  std::unique_ptr<grpc::Server> server_;
  std::mutex mutex_;  // guards what it was asked
  std::vector<std::uint64_t> watched_from_;
  std::vector<v1::SubmitRequest> submissions_;
  std::string last_cancelled_;
  v1::TrainFunctionsRequest last_training_;
};

}  // namespace regolab::client
