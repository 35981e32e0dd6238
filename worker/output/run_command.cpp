#include "worker/output/run_command.h"

#include <chrono>
#include <optional>

#include "worker/output/atomic_file.h"
#include "worker/output/progress_line.h"
#include "worker/output/result_json.h"

namespace regolab {
namespace {

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int exit_code(const Error& error) {
  switch (error.code) {
    case Code::kInvalidArgument:
    case Code::kNotFound:
    case Code::kAlreadyExists:
    case Code::kFailedPrecondition: return kExitInvalid;
    default: return kExitInternal;
  }
}

int fail(std::ostream& err, const Error& error) {
  err << "regolab-worker: " << error.text << "\n";
  return exit_code(error);
}

/// The job, or nothing with everything that is wrong with it on `err`.
std::optional<Job> job_from(const std::filesystem::path& file, std::ostream& err) {
  const auto text = read_whole_file(file);
  if (!text) {
    fail(err, text.error());
    return std::nullopt;
  }
  const Read<Job> read = read_job(*text, file.string());
  for (const Diagnostic& diagnostic : read.diagnostics) err << to_text(diagnostic) << "\n";
  return read.ok() ? read.value : std::nullopt;
}

std::string first_breach(const Job& job, const std::function<std::string(const StageSpec&)>& breach_of) {
  for (const StageSpec& spec : stages_of(job)) {
    if (std::string breach = breach_of(spec); !breach.empty()) return breach;
  }
  return "";
}

int verdict(const JobRun& run, std::ostream& err) {
  int code = kExitDone;
  for (const KeptStage& kept : run.stages) {
    if (kept.stage.result.end == StageEnd::kCompleted) continue;
    err << "regolab-worker: " << stage_name(kept.stage.spec.kind) << " ended as " << name_of(kept.stage.result.end) << ": "
        << kept.stage.result.reason << "\n";
    code = kExitUnphysical;
  }
  return code;
}

}  // namespace

int run_command(const RunCommand& command, const RunDoors& doors, std::ostream& out, std::ostream& err) {
  const std::optional<Job> job = job_from(command.job_file, err);
  if (!job) return kExitInvalid;
  if (const std::string breach = first_breach(*job, doors.breach_of); !breach.empty()) {
    return fail(err, invalid(command.job_file.string() + ": " + breach));
  }
  auto store = StageStore::open(command.directory, *job);
  if (!store) return fail(err, store.error());
  if (const auto before = store->end_before()) {
    out << command.directory.string() << ": done before, nothing to run\n";
    return *before == StageEnd::kCompleted ? kExitDone : kExitUnphysical;
  }

  ProgressLine line(err, command.terminal, steady_seconds);
  JobHooks hooks{.run_stage = doors.run_stage,
                 .on_note = [&](const std::string& text) { line.note(text); },
                 .threads = command.threads,
                 .checkpoint_every_s = command.checkpoint_every_s,
                 .stop = doors.stop};
  if (!command.quiet) {
    hooks.on_progress = [&](const StagePlace& place, const StageProgress& progress) { line.show(place, progress); };
    hooks.on_finished = [&](const StagePlace& place, const FinishedStage& stage) { line.finish(place, stage); };
  }
  const auto run = run_job(*job, *store, hooks);
  if (!run) return fail(err, run.error());
  if (run->interrupted) {
    line.note("interrupted; the same command goes on from here");
    return kExitInterrupted;
  }
  const auto written = write_outputs(command.directory, *job, *run, doors.view_bed, command.job_file.stem().string());
  if (!written) return fail(err, written.error());
  store->clear();
  if (!command.quiet)
    out << "results in " << command.directory.string() << ": result.json observations.yaml curves/ bed.vtp bed.xyz\n";
  return verdict(*run, err);
}

}  // namespace regolab
