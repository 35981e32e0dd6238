#include "worker/output/job_run.h"

#include <optional>

namespace regolab {
namespace {

/// Runs one stage with its checkpoints kept. A checkpoint that cannot be written stops the stage: better to say so now.
Result<StageOutput> run_from(const StagePlace& place, const std::string& bed, const std::string& checkpoint,
                             const StageStore& store, const JobHooks& hooks) {
  std::stop_source stop;
  const std::stop_callback forward(hooks.stop, [&stop] { stop.request_stop(); });
  std::optional<Error> not_saved;
  StageHooks stage_hooks{.on_progress = {},
                         .on_checkpoint =
                             [&](const std::string& bytes) {
                               if (auto saved = store.save_checkpoint(place.spec, bytes); !saved) {
                                 not_saved = saved.error();
                                 stop.request_stop();
                               }
                             },
                         .checkpoint_every_s = hooks.checkpoint_every_s,
                         .threads = hooks.threads,
                         .stop = stop.get_token()};
  if (hooks.on_progress) stage_hooks.on_progress = [&](const StageProgress& now) { hooks.on_progress(place, now); };
  auto output = hooks.run_stage(place.spec, bed, checkpoint, stage_hooks);
  if (not_saved) return *not_saved;
  return output;
}

/// The checkpoint may be of another version, or damaged: then the stage starts afresh.
Result<StageOutput> resume_or_run(const StagePlace& place, const std::string& bed, const StageStore& store,
                                  const JobHooks& hooks) {
  const std::string checkpoint = store.checkpoint(place.spec);
  auto output = run_from(place, bed, checkpoint, store, hooks);
  if (output || output.error().code != Code::kDataLoss || checkpoint.empty()) return output;
  if (hooks.on_note) hooks.on_note(stage_name(place.spec.kind) + ": starts afresh (" + output.error().text + ")");
  store.drop_checkpoint(place.spec);
  return run_from(place, bed, "", store, hooks);
}

}  // namespace

Result<JobRun> run_job(const Job& job, const StageStore& store, const JobHooks& hooks) {
  JobRun run;
  std::string bed;
  const std::vector<StageSpec> specs = stages_of(job);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const StagePlace place{.spec = specs[i], .number = i + 1, .count = specs.size()};
    std::optional<KeptStage> kept = store.finished(place.spec);
    if (!kept) {
      auto output = resume_or_run(place, bed, store, hooks);
      if (!output) return output.error();
      if (output->result.end == StageEnd::kCancelled) {
        run.interrupted = true;
        return run;
      }
      const bool pictured = place.spec.kind == StageKind::kRepose || place.spec.kind == StageKind::kPenetration;
      kept =
          KeptStage{{place.spec, std::move(output->result), output->steps, output->wall_s},
                    needs_bed(place.spec.kind) ? (pictured ? std::move(output->final_state) : "") : std::move(output->bed)};
      if (auto saved = store.keep(*kept); !saved) return saved.error();
    }
    if (hooks.on_finished) hooks.on_finished(place, kept->stage);
    const bool settled = kept->stage.result.end == StageEnd::kCompleted;
    if (place.spec.kind == StageKind::kSettle) bed = kept->state;
    run.stages.push_back(std::move(*kept));
    if (i == 0 && !settled) break;
  }
  return run;
}

}  // namespace regolab
