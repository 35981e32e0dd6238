#include "tests/unit/client/fake_lab.h"

#include <cstdlib>

namespace regolab::client {

FakeLab::FakeLab() {
  std::string pattern = std::filesystem::temp_directory_path() / "regolab-fake-XXXXXX";
  folder_ = mkdtemp(pattern.data());
  address_ = "unix:" + (folder_ / "socket").string();
  grpc::ServerBuilder builder;
  builder.AddListeningPort(address_, grpc::InsecureServerCredentials());
  builder.RegisterService(static_cast<v1::Experiments::Service*>(this));
  builder.RegisterService(static_cast<v1::Results::Service*>(this));
  builder.RegisterService(&blind);
  server_ = builder.BuildAndStart();
}

FakeLab::~FakeLab() {
  server_->Shutdown();
  server_->Wait();
  std::filesystem::remove_all(folder_);
}

std::vector<std::uint64_t> FakeLab::watched_from() {
  const std::lock_guard lock(mutex_);
  return watched_from_;
}

std::vector<v1::SubmitRequest> FakeLab::submissions() {
  const std::lock_guard lock(mutex_);
  return submissions_;
}

std::string FakeLab::last_cancelled() {
  const std::lock_guard lock(mutex_);
  return last_cancelled_;
}

v1::TrainFunctionsRequest FakeLab::last_training() {
  const std::lock_guard lock(mutex_);
  return last_training_;
}

grpc::Status FakeLab::Validate(Context*, const v1::SubmitRequest*, v1::SubmitReply* out) {
  *out = judged;
  return Status::OK;
}

grpc::Status FakeLab::Submit(Context*, const v1::SubmitRequest* in, v1::SubmitReply* out) {
  const std::lock_guard lock(mutex_);
  submissions_.push_back(*in);
  *out = submitted;
  return Status::OK;
}

grpc::Status FakeLab::List(Context*, const v1::ListRequest*, v1::ListReply* out) {
  for (const auto& experiment : experiments) *out->add_experiments() = experiment;
  return Status::OK;
}

/// Running until somebody watched it to its last event.
grpc::Status FakeLab::Get(Context*, const v1::GetRequest* in, v1::ExperimentStatus* out) {
  const std::lock_guard lock(mutex_);
  if (watched_from_.empty() && !experiments.empty())
    *out = experiments.front();
  else
    *out = final_status;
  out->set_experiment(in->experiment());
  return Status::OK;
}

grpc::Status FakeLab::Watch(Context*, const v1::WatchRequest* in, grpc::ServerWriter<v1::WatchEvent>* out) {
  {
    const std::lock_guard lock(mutex_);
    watched_from_.push_back(in->from_seq());
  }
  int sent = 0;
  for (const auto& event : events) {
    if (event.seq() < in->from_seq()) continue;
    out->Write(event);
    if (++sent == break_after) {
      break_after = -1;
      return {grpc::StatusCode::UNAVAILABLE, "going down"};
    }
  }
  return Status::OK;
}

grpc::Status FakeLab::Cancel(Context*, const v1::CancelRequest* in, v1::ExperimentStatus* out) {
  const std::lock_guard lock(mutex_);
  last_cancelled_ = in->experiment();
  *out = final_status;
  return Status::OK;
}

grpc::Status FakeLab::Retry(Context*, const v1::RetryRequest*, v1::ExperimentStatus* out) {
  *out = final_status;
  return Status::OK;
}

grpc::Status FakeLab::GetResults(Context*, const v1::ResultsRequest*, v1::ResultsReply* out) {
  *out = results;
  return refusal;
}

grpc::Status FakeLab::Range(Context*, const v1::RangeRequest*, v1::RangeReply* out) {
  *out = range;
  return refusal;
}

grpc::Status FakeLab::CheckArticle(Context*, const v1::CheckArticleRequest*, v1::CheckArticleReply* out) {
  *out = check;
  return Status::OK;
}

grpc::Status FakeLab::CompareArticle(Context*, const v1::CompareArticleRequest*, v1::CompareArticleReply* out) {
  *out = comparison;
  return refusal;
}

grpc::Status FakeLab::TrainFunctions(Context*, const v1::TrainFunctionsRequest* in, v1::TrainFunctionsReply* out) {
  const std::lock_guard lock(mutex_);
  last_training_ = *in;
  *out = functions;
  return refusal;
}

grpc::Status FakeLab::Export(Context*, const v1::ExportRequest*, grpc::ServerWriter<v1::ExportItem>* out) {
  for (const auto& item : items) out->Write(item);
  return Status::OK;
}

}  // namespace regolab::client
