/// `regolab-worker run JOB.yaml --out DIR`.
#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <stop_token>
#include <string>

#include "worker/output/job_run.h"
#include "worker/output/output_files.h"

namespace regolab {

enum ExitCode : int {
  kExitDone = 0,
  kExitInternal = 1,
  kExitUsage = 2,
  kExitInvalid = 3,     ///< the job file, or the folder, cannot be used
  kExitUnphysical = 5,  ///< a stage ended otherwise than completed; its reason is stored and printed
  kExitInterrupted = 130,
};

struct RunCommand {
  std::filesystem::path job_file;
  std::filesystem::path directory;
  int threads = 1;
  double checkpoint_every_s = 60;
  bool quiet = false;     ///< no progress
  bool terminal = false;  ///< `err` is one
};

/// The doors of the DEM, and where a stop request comes from.
struct RunDoors {
  decltype(JobHooks::run_stage) run_stage;
  std::function<std::string(const StageSpec&)> breach_of;
  ViewBed view_bed;
  std::stop_token stop = {};
};

/// Messages and progress go to `err`, where the results are to `out`. Returns the exit code.
int run_command(const RunCommand& command, const RunDoors& doors, std::ostream& out, std::ostream& err);

}  // namespace regolab
