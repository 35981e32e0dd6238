/// Results: tables, analyses and exports, read from the store on the caller's thread.
#pragma once
#include <string>

#include "regolab/v1/lab.grpc.pb.h"

namespace regolab {

class ResultsService final : public v1::Results::Service {
 public:
  explicit ResultsService(std::string database) : database_(std::move(database)) {}

  grpc::Status GetResults(grpc::ServerContext*, const v1::ResultsRequest*, v1::ResultsReply*) override;
  grpc::Status Range(grpc::ServerContext*, const v1::RangeRequest*, v1::RangeReply*) override;
  grpc::Status CheckArticle(grpc::ServerContext*, const v1::CheckArticleRequest*, v1::CheckArticleReply*) override;
  grpc::Status CompareArticle(grpc::ServerContext*, const v1::CompareArticleRequest*, v1::CompareArticleReply*) override;
  grpc::Status TrainFunctions(grpc::ServerContext*, const v1::TrainFunctionsRequest*, v1::TrainFunctionsReply*) override;
  grpc::Status Export(grpc::ServerContext*, const v1::ExportRequest*, grpc::ServerWriter<v1::ExportItem>*) override;

 private:
  const std::string database_;
};

}  // namespace regolab
