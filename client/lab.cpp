#include "client/lab.h"

#include <fmt/format.h>
#include <grpcpp/grpcpp.h>

#include <algorithm>
#include <thread>

#include "regolab/v1/lab.grpc.pb.h"

namespace regolab::client {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kCallLimit = 120s;    // analysis of the largest designs is far below
constexpr auto kStreamLimit = 5min;  // a stream is renewed, so that a peer that vanished without a word is noticed
constexpr auto kFitLimit = 1h;  // a bank without kernels is fitted first
constexpr auto kTrainLimit = 6h;
constexpr auto kReachLimit = 10s;
constexpr auto kTryAgainEvery = 200ms;
constexpr int kLargestReply = 256 << 20;  // the results of the largest design, all curves aside

std::chrono::system_clock::time_point wall(Clock::duration from_now) {
  return std::chrono::system_clock::now() + std::chrono::duration_cast<std::chrono::system_clock::duration>(from_now);
}

/// Cancels the call when any of the tokens is stopped.
class Cancelling {
 public:
  Cancelling(grpc::ClientContext& context, const std::vector<std::stop_token>& stops) {
    for (const auto& stop : stops) callbacks_.push_back(std::make_unique<Callback>(stop, Cancel{&context}));
  }

 private:
  struct Cancel {
    grpc::ClientContext* context;
    void operator()() const { context->TryCancel(); }
  };
  using Callback = std::stop_callback<Cancel>;
  std::vector<std::unique_ptr<Callback>> callbacks_;
};

bool any_stopped(const std::vector<std::stop_token>& stops) {
  return std::any_of(stops.begin(), stops.end(), [](const auto& stop) { return stop.stop_requested(); });
}

/// gRPC wraps the system's reason into a longer story; the end of it is what a person needs.
std::string reason_of(const std::string& story) {
  for (const std::string_view mark : {"last error: UNKNOWN: ", "last error: ", "; last error: UNAVAILABLE: "}) {
    if (const auto at = story.rfind(mark); at != std::string::npos) return story.substr(at + mark.size());
  }
  return story.empty() ? "no reason given" : story;
}

Outcome unreachable(const std::string& address, const std::string& why) {
  return failed(
      Exit::kUnreachable,
      fmt::format("no scheduler at {} ({}) start one with `regolab-scheduler --db FILE --listen {}`, correct --server or "
                  "REGOLAB_SERVER, or leave it out to work on a database file",
                  address, why, address));
}

Outcome outcome_of(const grpc::Status& status, const std::string& address) {
  switch (status.error_code()) {
    case grpc::StatusCode::OK: return done();
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::FAILED_PRECONDITION:
    case grpc::StatusCode::DATA_LOSS: return failed(Exit::kInvalidInput, status.error_message());
    case grpc::StatusCode::NOT_FOUND:
    case grpc::StatusCode::ALREADY_EXISTS: return failed(Exit::kUsage, status.error_message());
    case grpc::StatusCode::UNAVAILABLE: return unreachable(address, reason_of(status.error_message()));
    case grpc::StatusCode::UNIMPLEMENTED:
      return failed(Exit::kUnreachable,
                    fmt::format("{} is no Regolab scheduler of this version ({}) correct --server, or use programs "
                                "of one version",
                                address, status.error_message()));
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return failed(Exit::kTimeout,
                    fmt::format("the scheduler at {} did not answer in time (it may be busy) try again", address));
    case grpc::StatusCode::CANCELLED: return failed(Exit::kInterrupted, "");
    default:
      return failed(Exit::kInternal, status.error_message().empty()
                                         ? fmt::format("the call failed (gRPC code {}) see the scheduler's log",
                                                       static_cast<int>(status.error_code()))
                                         : status.error_message());
  }
}

}  // namespace

struct Lab::Stubs {
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<pb::Experiments::Stub> experiments;
  std::unique_ptr<pb::Results::Stub> results;
  std::unique_ptr<pb::Surrogates::Stub> surrogates;
  std::unique_ptr<pb::Gaps::Stub> gaps;
  std::unique_ptr<pb::Blind::Stub> blind;
};

Lab::Lab(Options options) : options_(std::move(options)), stubs_(std::make_unique<Stubs>()) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, 5000);  // one attempt may take so long
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 2000);
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetMaxReceiveMessageSize(kLargestReply);
  stubs_->channel = grpc::CreateCustomChannel(options_.address, grpc::InsecureChannelCredentials(), arguments);
  stubs_->experiments = pb::Experiments::NewStub(stubs_->channel);
  stubs_->results = pb::Results::NewStub(stubs_->channel);
  stubs_->surrogates = pb::Surrogates::NewStub(stubs_->channel);
  stubs_->gaps = pb::Gaps::NewStub(stubs_->channel);
  stubs_->blind = pb::Blind::NewStub(stubs_->channel);
}

Lab::~Lab() = default;

/// Every call of this service may be repeated, so one that did not get through is, for as long as our patience lasts.
template <class Call>
Outcome Lab::unary(const Call& call) {
  return unary(call, kCallLimit);
}

template <class Call>
Outcome Lab::unary(const Call& call, std::chrono::seconds limit) {
  const auto give_up = Clock::now() + options_.patience;
  while (true) {
    grpc::ClientContext context;
    context.set_deadline(wall(limit));
    const Cancelling cancelling(context, options_.stops);
    const grpc::Status status = call(context);
    const bool again = status.error_code() == grpc::StatusCode::UNAVAILABLE && Clock::now() < give_up;
    if (!again || any_stopped(options_.stops)) return outcome_of(status, options_.address);
    std::this_thread::sleep_for(kTryAgainEvery);
  }
}

Outcome Lab::reach() {
  const auto give_up = Clock::now() + kReachLimit;
  while (stubs_->channel->GetState(true) != GRPC_CHANNEL_READY) {
    if (any_stopped(options_.stops)) return failed(Exit::kInterrupted, "");
    if (stubs_->channel->GetState(false) == GRPC_CHANNEL_TRANSIENT_FAILURE) break;  // the call below learns why
    if (Clock::now() > give_up)
      return unreachable(options_.address, fmt::format("no answer within {} s", kReachLimit.count()));
    stubs_->channel->WaitForConnected(wall(kTryAgainEvery));
  }
  pb::ListReply ignored;
  return list(ignored);
}

Outcome Lab::validate(const pb::SubmitRequest& request, pb::SubmitReply& reply) {
  return unary([&](auto& context) { return stubs_->experiments->Validate(&context, request, &reply); });
}

Outcome Lab::submit(const pb::SubmitRequest& request, pb::SubmitReply& reply) {
  return unary([&](auto& context) { return stubs_->experiments->Submit(&context, request, &reply); });
}

Outcome Lab::list(pb::ListReply& reply) {
  return unary([&](auto& context) { return stubs_->experiments->List(&context, {}, &reply); });
}

Outcome Lab::get(const std::string& experiment, pb::ExperimentStatus& reply) {
  pb::GetRequest request;
  request.set_experiment(experiment);
  return unary([&](auto& context) { return stubs_->experiments->Get(&context, request, &reply); });
}

Outcome Lab::cancel(const std::string& experiment, pb::ExperimentStatus& reply) {
  pb::CancelRequest request;
  request.set_experiment(experiment);
  return unary([&](auto& context) { return stubs_->experiments->Cancel(&context, request, &reply); });
}

Outcome Lab::retry(const std::string& experiment, pb::ExperimentStatus& reply) {
  pb::RetryRequest request;
  request.set_experiment(experiment);
  return unary([&](auto& context) { return stubs_->experiments->Retry(&context, request, &reply); });
}

Outcome Lab::results(const std::string& experiment, pb::ResultsReply& reply) {
  pb::ResultsRequest request;
  request.set_experiment(experiment);
  return unary([&](auto& context) { return stubs_->results->GetResults(&context, request, &reply); });
}

Outcome Lab::range(const pb::RangeRequest& request, pb::RangeReply& reply) {
  return unary([&](auto& context) { return stubs_->results->Range(&context, request, &reply); });
}

Outcome Lab::check_article(pb::CheckArticleReply& reply) {
  return unary([&](auto& context) { return stubs_->results->CheckArticle(&context, {}, &reply); });
}

Outcome Lab::compare_article(const std::string& experiment, pb::CompareArticleReply& reply) {
  pb::CompareArticleRequest request;
  request.set_experiment(experiment);
  return unary([&](auto& context) { return stubs_->results->CompareArticle(&context, request, &reply); });
}

Outcome Lab::predict(const pb::PredictRequest& request, pb::PredictReply& reply) {
  return unary([&](auto& context) { return stubs_->surrogates->Predict(&context, request, &reply); });
}

Outcome Lab::models(pb::ListModelsReply& reply) {
  return unary([&](auto& context) { return stubs_->surrogates->ListModels(&context, {}, &reply); });
}

Outcome Lab::import_observations(const pb::ImportRequest& request, pb::ImportReply& reply) {
  return unary([&](auto& context) { return stubs_->gaps->Import(&context, request, &reply); });
}

Outcome Lab::bank(const pb::BankRequest& request, pb::BankReply& reply) {
  return unary([&](auto& context) { return stubs_->gaps->Bank(&context, request, &reply); });
}

Outcome Lab::invert(const pb::InvertRequest& request, pb::InvertReply& reply) {
  return unary([&](auto& context) { return stubs_->surrogates->Invert(&context, request, &reply); });
}

Outcome Lab::train(const pb::TrainRequest& request, const std::function<void(const pb::TrainEvent&)>& on_event, pb::TrainEvent& last) {
  grpc::ClientContext context;
  context.set_deadline(wall(kTrainLimit));
  const Cancelling cancelling(context, options_.stops);
  const auto stream = stubs_->surrogates->Train(&context, request);
  for (pb::TrainEvent event; stream->Read(&event);) {
    if (event.has_model()) last = event;
    else on_event(event);
  }
  return outcome_of(stream->Finish(), options_.address);
}

Outcome Lab::emulate(const pb::EmulateRequest& request, pb::EmulateReply& reply) {
  grpc::ClientContext context;  // minutes: no deadline
  return outcome_of(stubs_->gaps->Emulate(&context, request, &reply), options_.address);
}

/// Patience counts from the last step seen: a scheduler that comes back has lost at most the step it was at.
template <class Open>
Outcome Lab::steps(const Open& open, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last) {
  auto give_up = Clock::now() + options_.patience;
  while (true) {
    grpc::ClientContext context;
    const Cancelling cancelling(context, options_.stops);
    const auto stream = open(context);
    for (pb::DiagnoseEvent event; stream->Read(&event);) {
      if (event.has_diagnosis() || !event.diagnostics().empty()) last = event;
      else on_step(event);
      give_up = Clock::now() + options_.patience;
    }
    const grpc::Status status = stream->Finish();
    const bool again = status.error_code() == grpc::StatusCode::UNAVAILABLE && Clock::now() < give_up;
    if (!again || any_stopped(options_.stops)) return outcome_of(status, options_.address);
    std::this_thread::sleep_for(kTryAgainEvery);
  }
}

Outcome Lab::diagnose(const pb::DiagnoseRequest& request, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last) {
  return steps([&](auto& context) { return stubs_->gaps->Diagnose(&context, request); }, on_step, last);
}

Outcome Lab::locate(const pb::DiagnoseRequest& request, const std::function<void(const pb::DiagnoseEvent&)>& on_step, pb::DiagnoseEvent& last) {
  return steps([&](auto& context) { return stubs_->gaps->Locate(&context, request); }, on_step, last);
}

Outcome Lab::diagnoses(pb::ListDiagnosesReply& reply) {
  return unary([&](auto& context) { return stubs_->gaps->ListDiagnoses(&context, {}, &reply); });
}

Outcome Lab::diagnosis(const pb::GetDiagnosisRequest& request, pb::StoredDiagnosis& reply) {
  return unary([&](auto& context) { return stubs_->gaps->GetDiagnosis(&context, request, &reply); });
}

Outcome Lab::plan_confirmation(const pb::PlanRequest& request, pb::PlanReply& reply) {
  return unary([&](auto& context) { return stubs_->gaps->PlanConfirmation(&context, request, &reply); });
}

Outcome Lab::measure_shrinkage(const pb::ShrinkageRequest& request, pb::StoredDiagnosis& reply) {
  return unary([&](auto& context) { return stubs_->gaps->MeasureShrinkage(&context, request, &reply); }, kFitLimit);
}

Outcome Lab::draw_blind(const pb::BlindDrawRequest& request, pb::BlindDrawReply& reply) {
  return unary([&](auto& context) { return stubs_->blind->Draw(&context, request, &reply); });
}

Outcome Lab::design_blind(const pb::BlindTruth& request, pb::BlindDesignReply& reply) {
  return unary([&](auto& context) { return stubs_->blind->Design(&context, request, &reply); });
}

Outcome Lab::observe_blind(const pb::BlindObserveRequest& request, pb::BlindObserveReply& reply) {
  return unary([&](auto& context) { return stubs_->blind->Observe(&context, request, &reply); });
}

Outcome Lab::score_blind(const std::vector<pb::BlindScoreRequest>& messages, pb::BlindScoreReply& reply) {
  grpc::ClientContext context;  // minutes where a bank is fitted first: no deadline
  const Cancelling cancelling(context, options_.stops);
  const auto stream = stubs_->blind->Score(&context, &reply);
  for (const auto& message : messages) {
    if (!stream->Write(message)) break;  // Finish says why
  }
  stream->WritesDone();
  return outcome_of(stream->Finish(), options_.address);
}

Outcome Lab::train_functions(const std::string& experiment, std::uint64_t seed, pb::TrainFunctionsReply& reply) {
  pb::TrainFunctionsRequest request;
  request.set_experiment(experiment);
  request.set_seed(seed);
  return unary([&](auto& context) { return stubs_->results->TrainFunctions(&context, request, &reply); });
}

Outcome Lab::watch(const std::string& experiment, std::uint64_t from_seq, Clock::time_point until,
                   const std::function<void(const pb::WatchEvent&)>& on_event) {
  grpc::ClientContext context;
  context.set_deadline(wall(std::min<Clock::duration>(until - Clock::now(), kStreamLimit)));
  const Cancelling cancelling(context, options_.stops);
  pb::WatchRequest request;
  request.set_experiment(experiment);
  request.set_from_seq(from_seq);
  const auto stream = stubs_->experiments->Watch(&context, request);
  for (pb::WatchEvent event; stream->Read(&event);) on_event(event);
  const grpc::Status status = stream->Finish();
  const bool renew = status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED && Clock::now() < until;
  return renew ? done() : outcome_of(status, options_.address);
}

Outcome Lab::export_stages(const std::string& experiment, const std::function<Outcome(const pb::ExportItem&)>& on_item) {
  grpc::ClientContext context;
  const Cancelling cancelling(context, options_.stops);
  pb::ExportRequest request;
  request.set_experiment(experiment);
  const auto stream = stubs_->results->Export(&context, request);
  Outcome kept = done();
  for (pb::ExportItem item; stream->Read(&item);) {
    if (kept = on_item(item); !kept.ok()) {
      context.TryCancel();
      break;
    }
  }
  const grpc::Status status = stream->Finish();
  return kept.ok() ? outcome_of(status, options_.address) : kept;
}

}  // namespace regolab::client
