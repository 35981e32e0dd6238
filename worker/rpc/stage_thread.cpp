#include "worker/rpc/stage_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace regolab {

StageThread::StageThread(StageOrder order, StageFunction run, ArtifactDoor door, Options options,
                         std::function<void()> on_done)
    : order_(std::move(order)),
      run_(std::move(run)),
      door_(std::move(door)),
      options_(options),
      on_done_(std::move(on_done)),
      keeper_([this](const std::stop_token& stop) { keep_checkpoints(stop); }),
      worker_([this](const std::stop_token& stop) { work(stop); }) {}

StageThread::~StageThread() {
  stop();
  worker_ = {};  // joins; only then may the keeper end
  keeper_ = {};
}

void StageThread::stop() { worker_.request_stop(); }

bool StageThread::done() const {
  const std::lock_guard lock(mutex_);
  return outcome_.has_value();
}

StageReport StageThread::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

StageThread::Outcome StageThread::take(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return !to_keep_ && !keeping_; });
  return std::move(*outcome_);
}

void StageThread::work(const std::stop_token& stop) {
  Outcome outcome;
  try {
    outcome = run(stop);
  } catch (const std::bad_alloc&) {
    outcome.output = Error{Code::kResourceExhausted, "out of memory, use fewer particles or a larger machine"};
  } catch (const std::exception& thrown) {
    outcome.output = Error{Code::kInternal, std::string("the stage threw (") + thrown.what() + ")"};
  }
  {
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
  }
  on_done_();
}

StageThread::Outcome StageThread::run(const std::stop_token& stop) {
  Outcome outcome;
  std::string bed, checkpoint;
  if (!order_.bed.empty()) {
    auto got = patiently(stop, [&] { return door_.get(order_.bed); });
    if (!got.ok())
      return {.output = Error{Code::kUnavailable, "no bed to start from (" + got.error().text + ")"}, .bed = {}};
    bed = std::move(*got);
  }
  if (!order_.checkpoint.empty()) {
    if (auto got = patiently(stop, [&] { return door_.get(order_.checkpoint); }); got.ok()) checkpoint = std::move(*got);
  }
  const StageHooks hooks{.on_progress =
                             [this](const StageProgress& p) {
                               const std::lock_guard lock(mutex_);
                               report_.phase = p.phase;
                               report_.fraction = p.fraction;
                               report_.steps = p.steps;
                               report_.sphere_steps_per_s = p.sphere_steps_per_s;
                             },
                         .on_checkpoint =
                             [this](const std::string& bytes) {
                               const std::lock_guard lock(mutex_);
                               to_keep_ = bytes;  // an older one still waiting is not worth sending
                               changed_.notify_all();
                             },
                         .checkpoint_every_s = options_.checkpoint_every_s,
                         .threads = options_.threads,
                         .stop = stop};
  outcome.output = run_(order_.spec, bed, checkpoint, hooks);
  if (!checkpoint.empty() && !outcome.output.ok() && outcome.output.error().code == Code::kDataLoss) {
    outcome.output = run_(order_.spec, bed, {}, hooks);  // the checkpoint is unusable: from the start
  }
  const bool leaves_bed =
      outcome.output.ok() && order_.spec.kind == StageKind::kSettle && outcome.output->result.end == StageEnd::kCompleted;
  if (!leaves_bed) return outcome;
  auto put = patiently(stop, [&] { return door_.put(outcome.output->bed); });
  if (put.ok())
    outcome.bed = std::move(*put);
  else
    outcome.output = Error{Code::kUnavailable, "the bed could not be stored (" + put.error().text + ")"};
  return outcome;
}

Result<std::string> StageThread::patiently(const std::stop_token& stop, const std::function<Result<std::string>()>& call) {
  std::chrono::milliseconds pause{100};
  while (true) {
    auto got = call();
    if (got.ok() || stop.stop_requested()) return got;
    const Code code = got.error().code;
    if (code != Code::kUnavailable && code != Code::kResourceExhausted && code != Code::kAborted) return got;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, pause, [] { return false; });
    pause = std::min(2 * pause, std::chrono::milliseconds{2000});
  }
}

void StageThread::keep_checkpoints(const std::stop_token& stop) {
  while (true) {
    std::string bytes;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return to_keep_.has_value(); })) return;
      bytes = std::move(*to_keep_);
      to_keep_.reset();
      keeping_ = true;
    }
    const auto digest = door_.put(bytes);  // once: the next one is soon here
    const std::lock_guard lock(mutex_);
    keeping_ = false;
    if (digest.ok()) report_.checkpoint = *digest;
    changed_.notify_all();
  }
}

}  // namespace regolab
