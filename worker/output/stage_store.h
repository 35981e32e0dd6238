/// What a run of a job leaves in DIR/.checkpoint while it lasts, so that a killed run goes on where it stopped.
///   job                 which job this folder belongs to
///   <stage_key>.json    a finished stage; written after its state, so that it vouches for it
///   <stage_key>.state   the settled bed, or the last state of a repose or penetration stage
///   <stage_key>.partial the latest checkpoint of the stage that was running
///   lock                held while a run works in the folder
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "input/job_file.h"
#include "vocab/result.h"
#include "worker/output/finished_stage.h"

namespace regolab {

/// A finished stage with the bytes it left (empty for fabric and stress stages).
struct KeptStage {
  FinishedStage stage;
  std::string state;
};

class StageStore {
 public:
  /// Makes `directory` where needed and takes its lock. Errors: kAlreadyExists (results or an unfinished run of another job
  /// stand there), kFailedPrecondition (not writable, or another run works in it), kResourceExhausted (disk full).
  static Result<StageStore> open(const std::filesystem::path& directory, const Job& job);

  StageStore(StageStore&& other) noexcept;
  StageStore& operator=(StageStore&&) = delete;
  ~StageStore();

  /// How the job ended when it was finished before (its result.json is in the folder); nothing when it was not.
  std::optional<StageEnd> end_before() const { return end_before_; }

  /// Nothing when the stage was not finished, or its record is damaged: then it has to run (again).
  std::optional<KeptStage> finished(const StageSpec& spec) const;
  Result<void> keep(const KeptStage& kept) const;

  /// Empty when there is none.
  std::string checkpoint(const StageSpec& spec) const;
  Result<void> save_checkpoint(const StageSpec& spec, const std::string& bytes) const;
  void drop_checkpoint(const StageSpec& spec) const;

  /// Removes .checkpoint: the results stand in the folder now.
  void clear();

 private:
  StageStore(std::filesystem::path folder, int lock) : folder_(std::move(folder)), lock_(lock) {}
  std::filesystem::path file(const StageSpec& spec, const char* ending) const;
  Result<void> claim(const std::filesystem::path& directory, const Job& job);

  std::filesystem::path folder_;
  int lock_ = -1;  ///< descriptor
  std::optional<StageEnd> end_before_;
};

}  // namespace regolab
