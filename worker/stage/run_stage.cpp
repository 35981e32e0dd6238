#include "worker/stage/run_stage.h"

#include <chrono>
#include <memory>

#include "vocab/canonical.h"
#include "worker/protocol/fabric.h"
#include "worker/protocol/penetration.h"
#include "worker/protocol/repose.h"
#include "worker/protocol/settle.h"
#include "worker/protocol/stress.h"
#include "worker/stage/envelope.h"
#include "worker/stage/open_bed.h"

namespace regolab {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::unique_ptr<protocol::Test> make_test(const StageSpec& spec, protocol::Bed bed) {
  bed.effects = spec.effects;
  switch (spec.kind) {
    case StageKind::kSettle: return std::make_unique<protocol::Settle>(std::move(bed), spec);
    case StageKind::kRepose: return std::make_unique<protocol::Repose>(std::move(bed));
    case StageKind::kPenetration: return std::make_unique<protocol::Penetration>(std::move(bed), spec);
    default: return std::make_unique<protocol::Stress>(std::move(bed), spec);
  }
}

std::string bed_bytes(const StageSpec& spec, protocol::Bed& bed) {
  dem::Saver saver;
  bed.archive(saver);
  return seal(Content::kBed, canonical_text(parent_of(spec)), saver.take());
}

/// Runs a test to its end, telling the hooks now and then.
class Runner {
 public:
  Runner(const StageSpec& spec, const StageHooks& hooks, protocol::Test& test) : spec_(spec), hooks_(hooks), test_(test) {}

  protocol::Ending run() {
    start_ = told_ = checkpointed_ = Clock::now();
    steps_before_ = test_.steps();
    while (true) {
      if (hooks_.stop.stop_requested()) {
        give_checkpoint();
        return {StageEnd::kCancelled, "stopped before its end (asked to) run it again"};
      }
      if (auto ending = test_.advance()) return *ending;
      if (seconds_since(told_) > 0.2) tell();
      if (seconds_since(checkpointed_) > hooks_.checkpoint_every_s) give_checkpoint();
    }
  }

 private:
  void tell() {
    told_ = Clock::now();
    if (!hooks_.on_progress) return;
    const double spheres = test_.bed().world.spheres.count();
    const auto now = static_cast<double>(test_.steps() - steps_before_);
    hooks_.on_progress({test_.phase(), test_.fraction(), static_cast<std::uint64_t>(test_.steps()), now * spheres / seconds_since(start_)});
  }
  void give_checkpoint() {
    checkpointed_ = Clock::now();
    if (!hooks_.on_checkpoint) return;
    dem::Saver saver;
    test_.save(saver);
    hooks_.on_checkpoint(seal(Content::kCheckpoint, canonical_text(spec_), saver.take()));
  }

  const StageSpec& spec_;
  const StageHooks& hooks_;
  protocol::Test& test_;
  Clock::time_point start_, told_, checkpointed_;
  std::int64_t steps_before_ = 0;  ///< made before this resume
};

Result<void> resume(const StageSpec& spec, const std::string& checkpoint, protocol::Test& test) {
  const auto payload = unseal(Content::kCheckpoint, canonical_text(spec), checkpoint);
  if (!payload) return payload.error();
  dem::Loader loader(*payload);
  test.load(loader);
  if (!loader.finished()) return Error{Code::kDataLoss, "unusable checkpoint (its length is wrong) start the stage anew"};
  return {};
}

/// The specimen a stage starts from: generated for settling, the parent's bed else.
struct Specimen {
  protocol::Bed bed;
  std::string no_room;
};
Result<Specimen> specimen_for(const StageSpec& spec, const std::string& bed) {
  Specimen out;
  if (spec.kind == StageKind::kSettle) {
    out.no_room = protocol::generate_bed(spec, out.bed);
    return out;
  }
  auto opened = open_bed(bed, canonical_text(parent_of(spec)));
  if (!opened) return opened.error();
  out.bed = std::move(*opened);
  return out;
}

StageOutput run_test(const StageSpec& spec, const StageHooks& hooks, protocol::Test& test) {
  test.bed().world.threads = std::max(1, hooks.threads);
  Runner runner(spec, hooks, test);
  const protocol::Ending ending = runner.run();
  StageOutput out;
  out.result = test.result(ending);
  out.steps = static_cast<std::uint64_t>(test.steps());
  if (ending.end == StageEnd::kCancelled) return out;
  std::string bytes = bed_bytes(spec, test.bed());
  (spec.kind == StageKind::kSettle ? out.bed : out.final_state) = std::move(bytes);
  return out;
}

}  // namespace

Result<StageOutput> run_stage(const StageSpec& asked, const std::string& bed, const std::string& checkpoint,
                              const StageHooks& hooks) {
  const auto start = Clock::now();
  StageSpec spec = asked;
  spec.effects = acting_in(asked.effects, asked.kind);  // what the stage's key does not say must not show
  if (std::string breach = breach_of(spec); !breach.empty()) return invalid(std::move(breach));
  StageOutput out;
  if (spec.kind == StageKind::kFabric) {
    auto specimen = specimen_for(spec, bed);
    if (!specimen) return specimen.error();
    specimen->bed.effects = spec.effects;
    out.result = protocol::measure_fabric(specimen->bed);
  } else {
    std::unique_ptr<protocol::Test> test;
    if (checkpoint.empty()) {
      auto specimen = specimen_for(spec, bed);
      if (!specimen) return specimen.error();
      if (!specimen->no_room.empty()) {
        out.result = {.end = StageEnd::kNoRoom, .reason = specimen->no_room};
        return out;
      }
      test = make_test(spec, std::move(specimen->bed));
    } else {
      test = make_test(spec, {});
      if (auto resumed = resume(spec, checkpoint, *test); !resumed) return resumed.error();
    }
    out = run_test(spec, hooks, *test);
  }
  out.wall_s = seconds_since(start);
  return out;
}

}  // namespace regolab
