#include "worker/rpc/session.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "rpc/convert.h"
#include "vocab/job.h"

namespace regolab {
namespace {

constexpr std::uint32_t kIdleHoldMs = 20'000;
constexpr std::uint32_t kFirstHoldMs = 150;  // a stage that dies early should have been heard
constexpr std::chrono::seconds kEarly{2};
constexpr std::chrono::seconds kFarewell{5};  // a leaving worker waits so long for an absent scheduler
constexpr std::chrono::milliseconds kLongestBackoff{2000};
constexpr std::size_t kBedsKept = 4;
constexpr std::size_t kLargestReport = (4U << 20) - 65536;  // what a scheduler takes in one message, less what is around it

v1::JobError to_job_error(const Error& error) {
  v1::JobError out;
  switch (error.code) {
    case Code::kInvalidArgument:
    case Code::kDataLoss:
    case Code::kFailedPrecondition: out.set_class_(v1::ERROR_PERMANENT); break;
    case Code::kResourceExhausted: out.set_class_(v1::ERROR_RESOURCE); break;
    default: out.set_class_(v1::ERROR_TRANSIENT);
  }
  out.set_text(error.text);
  return out;
}

}  // namespace

Session::Session(SessionOptions options, StageFunction run)
    : options_(std::move(options)), run_(std::move(run)), link_(options_.server) {}

void Session::leave() {
  leaving_ = true;
  link_.wake();
}

int Session::run() {
  while (!gone_) {
    link_.clear_wake();  // whatever woke us is looked at below
    if (leaving_ && left_at_ == Clock::time_point{}) {
      left_at_ = Clock::now();
      if (stage_) stage_->stop();
    }
    if (leaving_ && !stage_ && !finished_ && !unanswered_) break;
    if (stage_ && stage_->done()) end_stage();
    const v1::SyncRequest request = next_request();
    const auto reply = link_.sync(request);
    if (reply.ok()) {
      backoff_ = std::chrono::milliseconds{100};
      unanswered_.reset();
      act(*reply);
    } else if (!retry_after(reply.error())) {
      break;
    }
  }
  return exit_code_;
}

v1::SyncRequest Session::next_request() {
  if (unanswered_ && !unanswered_->slot().has_running() && unanswered_->draining() == leaving_) return *unanswered_;
  v1::SyncRequest request;
  request.set_worker(options_.name);
  request.set_seq(++seq_);
  request.set_physics_version(kPhysicsVersion);
  request.set_draining(leaving_);
  if (finished_) {
    *request.mutable_slot()->mutable_finished() = *finished_;
  } else if (stage_) {
    describe_running(*request.mutable_slot()->mutable_running());
    const bool early = Clock::now() - begun_ < kEarly;
    request.set_hold_ms(early ? std::min(kFirstHoldMs, next_sync_ms_) : next_sync_ms_);
  } else {
    request.mutable_slot()->mutable_idle();
    request.set_hold_ms(leaving_ ? 0 : kIdleHoldMs);
  }
  unanswered_ = request;
  return request;
}

void Session::describe_running(v1::Running& running) {
  const StageReport report = stage_->report();
  running.set_job(job_);
  running.set_lease_token(token_);
  running.set_phase(report.phase);
  running.set_fraction(report.fraction);
  running.set_steps(report.steps);
  running.set_sphere_steps_per_s(report.sphere_steps_per_s);
  running.set_checkpoint(report.checkpoint);
  told_checkpoint_ = report.checkpoint;
}

/// The stage has ended, one way or the other: from here on it is a report to be delivered.
void Session::end_stage() {
  StageThread::Outcome outcome = stage_->take(std::chrono::seconds(leaving_ ? 3 : 0));
  const StageReport report = stage_->report();
  const bool stopped = outcome.output.ok() && outcome.output->result.end == StageEnd::kCancelled;
  const bool cut_short = leaving_ && !outcome.output.ok();
  if ((stopped || cut_short) && report.checkpoint != told_checkpoint_) {
    v1::SyncRequest request;  // the next holder starts from here
    request.set_worker(options_.name);
    request.set_seq(++seq_);
    request.set_physics_version(kPhysicsVersion);
    describe_running(*request.mutable_slot()->mutable_running());
    if (const auto reply = link_.sync(request); !reply.ok())
      spdlog::warn("last checkpoint not announced: {}", reply.error().text);
  }
  stage_.reset();
  unanswered_.reset();
  v1::Finished& finished = finished_.emplace();
  finished.set_job(job_);
  finished.set_lease_token(token_);
  if (stopped || cut_short) {
    finished.mutable_error()->set_class_(v1::ERROR_PREEMPTED);
    finished.mutable_error()->set_text("the worker was told to stop");
  } else if (!outcome.output.ok()) {
    *finished.mutable_error() = to_job_error(outcome.output.error());
    spdlog::warn("job {}: {}", job_, outcome.output.error().text);
  } else {
    *finished.mutable_result() = to_proto(outcome.output->result);
    finished.set_bed(outcome.bed);
    finished.set_wall_s(outcome.output->wall_s);
    finished.set_steps(outcome.output->steps);
    if (const std::size_t size = finished.ByteSizeLong(); size > kLargestReport) {  // it would be refused for ever
      finished.mutable_error()->set_class_(v1::ERROR_PERMANENT);
      finished.mutable_error()->set_text("result too large (" + std::to_string(size) + " bytes, at most " +
                                         std::to_string(kLargestReport) + "), store fewer curve points");
    }
    spdlog::info("job {}: {} after {:.1f} s", job_, name_of(outcome.output->result.end), outcome.output->wall_s);
  }
}

void Session::act(const v1::SyncReply& reply) {
  if (reply.next_sync_in_ms() > 0) next_sync_ms_ = reply.next_sync_in_ms();
  finished_.reset();  // answered, so accepted or refused for good
  switch (reply.order_case()) {
    case v1::SyncReply::kStart: return begin(reply.start());
    case v1::SyncReply::kDrop:
      spdlog::info("job {} dropped: {}", job_, reply.drop().why());
      if (stage_) stage_->stop();
      stage_.reset();
      return;
    case v1::SyncReply::kLeave: gone_ = true; return;
    default: return;
  }
}

void Session::begin(const v1::Start& start) {
  if (stage_ && start.lease_token() == token_) return;  // already at it
  stage_.reset();
  job_ = start.job();
  token_ = start.lease_token();
  begun_ = Clock::now();
  told_checkpoint_ = start.checkpoint();
  const auto spec = from_proto(start.spec());
  if (!spec.ok() || leaving_) {
    v1::Finished& finished = finished_.emplace();
    finished.set_job(job_);
    finished.set_lease_token(token_);
    if (spec.ok())
      finished.mutable_error()->set_class_(v1::ERROR_PREEMPTED);
    else
      *finished.mutable_error() = to_job_error(spec.error());
    return;
  }
  spdlog::info("job {}: {} seed {}{}", job_, name_of(spec->kind), spec->seed, start.checkpoint().empty() ? "" : ", resumed");
  ArtifactDoor door{.get = [this](const std::string& digest) { return get(digest); },
                    .put = [this](const std::string& bytes) { return link_.upload(bytes); }};
  stage_ = std::make_unique<StageThread>(StageOrder{*spec, start.bed(), start.checkpoint()}, run_, std::move(door),
                                         options_.stage, [this] { link_.wake(); });
}

bool Session::retry_after(const Error& error) {
  if (error.code == Code::kCancelled) return true;  // we woke ourselves: there is something new to say
  if (leaving_ && Clock::now() - left_at_ > kFarewell) return false;
  if (error.code == Code::kFailedPrecondition && error.text.find("physics version") != std::string::npos) {
    spdlog::error("{}", error.text);
    exit_code_ = 1;
    return false;
  }
  if (finished_ && finished_->has_result() && error.code == Code::kFailedPrecondition) {
    // The bed went missing over there between upload and report. Handing the job back makes it again, bit for bit.
    finished_->mutable_error()->set_class_(v1::ERROR_TRANSIENT);
    finished_->mutable_error()->set_text(error.text);
    unanswered_.reset();
    return true;
  }
  if (finished_ && error.code == Code::kInvalidArgument) {  // it will never be taken
    spdlog::error("job {}: report refused: {}", job_, error.text);
    finished_->mutable_error()->set_class_(v1::ERROR_PERMANENT);
    finished_->mutable_error()->set_text("the report was refused (" + error.text + ")");
    unanswered_.reset();
  }
  if (backoff_ == std::chrono::milliseconds{100}) spdlog::warn("{}: {}; trying again", options_.server, error.text);
  pause();
  return true;
}

void Session::pause() {
  const auto until = Clock::now() + backoff_;
  while (Clock::now() < until && !(leaving_ && left_at_ == Clock::time_point{}))
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  backoff_ = std::min(2 * backoff_, kLongestBackoff);
}

Result<std::string> Session::get(const std::string& digest) {
  {
    const std::lock_guard lock(beds_mutex_);
    if (const auto held = beds_.find(digest); held != beds_.end()) return held->second;
  }
  auto bytes = link_.download(digest);
  const std::lock_guard lock(beds_mutex_);
  if (bytes.ok()) {
    if (beds_.size() >= kBedsKept) beds_.erase(beds_.begin());
    beds_[digest] = *bytes;
  }
  return bytes;
}

}  // namespace regolab
