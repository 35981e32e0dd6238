#include "scheduler/rpc/results.h"

#include "rpc/convert.h"
#include "scheduler/analysis/table_shape.h"
#include "scheduler/rpc/analysis_convert.h"
#include "scheduler/rpc/functions_convert.h"
#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/result_table.h"

namespace regolab {
namespace {

Result<NamedTable> table_of(const std::string& database, const std::string& label) {
  auto reader = Reader::open(database);
  if (!reader.ok()) return reader.error();
  return result_table(*reader, label);
}

v1::ExportItem item_of(const StoredStage& stage) {
  v1::ExportItem item;
  item.set_point(stage.link.point);
  item.set_seed(stage.link.seed);
  *item.mutable_spec() = to_proto(stage.record.identity.spec);
  item.set_stage_key(stage.record.identity.key);
  item.set_state(std::string(name_of(stage.record.status.state)));
  item.set_wall_s(stage.record.status.wall_s);
  item.set_steps(stage.record.status.steps);
  return item;
}

}  // namespace

grpc::Status ResultsService::GetResults(grpc::ServerContext*, const v1::ResultsRequest* request, v1::ResultsReply* reply) {
  const auto table = table_of(database_, request->experiment());
  if (!table.ok()) return to_grpc(table.error());
  *reply = to_proto(table->table, table->name);
  return grpc::Status::OK;
}

grpc::Status ResultsService::Range(grpc::ServerContext*, const v1::RangeRequest* request, v1::RangeReply* reply) {
  const bool article = request->experiment().empty();
  auto table = article ? Result<NamedTable>(NamedTable{analysis::article_results(), "article"})
                       : table_of(database_, request->experiment());
  if (!table.ok()) return to_grpc(table.error());
  const auto kept =
      analysis::without_points(std::move(table->table), {request->without().begin(), request->without().end()});
  if (!kept.ok()) return to_grpc(kept.error());
  const auto ranges = analysis::analyse_ranges(*kept, request->response());
  if (!ranges.ok()) return to_grpc(ranges.error());
  *reply = to_proto(article ? "article" : request->experiment(), *ranges);
  return grpc::Status::OK;
}

grpc::Status ResultsService::CheckArticle(grpc::ServerContext*, const v1::CheckArticleRequest*,
                                          v1::CheckArticleReply* reply) {
  *reply = to_proto(analysis::check_article());
  return grpc::Status::OK;
}

grpc::Status ResultsService::CompareArticle(grpc::ServerContext*, const v1::CompareArticleRequest* request,
                                            v1::CompareArticleReply* reply) {
  const auto table = table_of(database_, request->experiment());
  if (!table.ok()) return to_grpc(table.error());
  const auto comparison = analysis::compare_article(table->table);
  if (!comparison.ok()) return to_grpc(comparison.error());
  *reply = to_proto(request->experiment(), *comparison);
  return grpc::Status::OK;
}

grpc::Status ResultsService::TrainFunctions(grpc::ServerContext*, const v1::TrainFunctionsRequest* request,
                                            v1::TrainFunctionsReply* reply) {
  if (request->experiment().empty()) {
    *reply = to_proto(surrogate::train_article_functions(request->seed()));
    return grpc::Status::OK;
  }
  const auto table = table_of(database_, request->experiment());
  if (!table.ok()) return to_grpc(table.error());
  const auto report = surrogate::train_functions(table->table, request->seed());
  if (!report.ok()) return to_grpc(report.error());
  *reply = to_proto(*report);
  return grpc::Status::OK;
}

grpc::Status ResultsService::Export(grpc::ServerContext* context, const v1::ExportRequest* request,
                                    grpc::ServerWriter<v1::ExportItem>* writer) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const auto design = reader->design(request->experiment());
  if (!design.ok()) return to_grpc(design.error());
  const auto stages = reader->stages(design->id);
  if (!stages.ok()) return to_grpc(stages.error());
  for (const StoredStage& stage : *stages) {
    v1::ExportItem item = item_of(stage);
    if (stage.record.status.end) {
      const auto result = reader->result(stage.link.job);
      if (!result.ok()) return to_grpc(result.error());
      *item.mutable_result() = to_proto(*result);
    } else if (!stage.record.status.detail.empty()) {
      item.mutable_result()->set_end(v1::END_CANCELLED);
      item.mutable_result()->set_reason(stage.record.status.detail);
    }
    if (context->IsCancelled() || !writer->Write(item)) return {grpc::StatusCode::CANCELLED, "the reader has gone"};
  }
  return grpc::Status::OK;
}

}  // namespace regolab
