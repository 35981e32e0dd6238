/// The scheduler as seen by a verb: one method per call of lab.proto, errors as outcomes.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "client/outcome.h"
#include "client/wire.h"

namespace regolab::client {

class Lab {
 public:
  struct Options {
    std::string address;                      ///< "host:port" or "unix:/path"
    std::vector<std::stop_token> stops = {};  ///< any of them cancels the call under way
    std::chrono::seconds patience{0};         ///< how long a call tries again when the scheduler is away
  };
  explicit Lab(Options options);
  ~Lab();

  /// Is anybody there, and does it speak our protocol? The outcome says what was tried.
  Outcome reach();

  Outcome validate(const pb::SubmitRequest& request, pb::SubmitReply& reply);
  Outcome submit(const pb::SubmitRequest& request, pb::SubmitReply& reply);
  Outcome list(pb::ListReply& reply);
  Outcome get(const std::string& experiment, pb::ExperimentStatus& reply);
  Outcome cancel(const std::string& experiment, pb::ExperimentStatus& reply);
  Outcome retry(const std::string& experiment, pb::ExperimentStatus& reply);
  Outcome results(const std::string& experiment, pb::ResultsReply& reply);
  Outcome range(const pb::RangeRequest& request, pb::RangeReply& reply);
  Outcome check_article(pb::CheckArticleReply& reply);
  Outcome compare_article(const std::string& experiment, pb::CompareArticleReply& reply);
  Outcome train_functions(const std::string& experiment, std::uint64_t seed, pb::TrainFunctionsReply& reply);

  Outcome predict(const pb::PredictRequest& request, pb::PredictReply& reply);
  Outcome models(pb::ListModelsReply& reply);
  Outcome invert(const pb::InvertRequest& request, pb::InvertReply& reply);
  Outcome import_observations(const pb::ImportRequest& request, pb::ImportReply& reply);
  Outcome bank(const pb::BankRequest& request, pb::BankReply& reply);
  Outcome emulate(const pb::EmulateRequest& request, pb::EmulateReply& reply);
  /// The last event holds the diagnosis, or why the files were refused. A stream that broke is asked for again: it goes on where it was.
  Outcome diagnose(const pb::DiagnoseRequest& request, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last);
  Outcome locate(const pb::DiagnoseRequest& request, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last);
  Outcome diagnoses(pb::ListDiagnosesReply& reply);
  Outcome diagnosis(const pb::GetDiagnosisRequest& request, pb::StoredDiagnosis& reply);
  Outcome plan_confirmation(const pb::PlanRequest& request, pb::PlanReply& reply);
  Outcome measure_shrinkage(const pb::ShrinkageRequest& request, pb::StoredDiagnosis& reply);
  Outcome draw_blind(const pb::BlindDrawRequest& request, pb::BlindDrawReply& reply);
  Outcome design_blind(const pb::BlindTruth& request, pb::BlindDesignReply& reply);
  Outcome observe_blind(const pb::BlindObserveRequest& request, pb::BlindObserveReply& reply);
  /// The bank first, then the cases.
  Outcome score_blind(const std::vector<pb::BlindScoreRequest>& messages, pb::BlindScoreReply& reply);
  /// Until the model is stored; `last` is the event that carries it.
  Outcome train(const pb::TrainRequest& request, const std::function<void(const pb::TrainEvent&)>& on_event, pb::TrainEvent& last);

  /// One stream, until it ends or is due for renewal; kUnreachable when it broke. `until` ends it with kTimeout.
  Outcome watch(const std::string& experiment, std::uint64_t from_seq, std::chrono::steady_clock::time_point until,
                const std::function<void(const pb::WatchEvent&)>& on_event);
  /// Stops at the first outcome of `on_item` that is not ok, and returns it.
  Outcome export_stages(const std::string& experiment, const std::function<Outcome(const pb::ExportItem&)>& on_item);

  const std::string& address() const { return options_.address; }

 private:
  struct Stubs;
  template <class Call>
  Outcome unary(const Call& call, std::chrono::seconds limit);
  template <class Call>
  Outcome unary(const Call& call);
  template <class Open>
  Outcome steps(const Open& open, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last);

  Options options_;
  std::unique_ptr<Stubs> stubs_;
};

}  // namespace regolab::client
