/// The files of a finished job.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "input/job_file.h"
#include "vocab/result.h"
#include "worker/output/job_run.h"
#include "worker/stage/run_stage.h"

namespace regolab {

using ViewBed = std::function<Result<BedView>(const std::string& bed)>;

/// Writes observations.yaml, curves/<id>.csv, bed.vtp, bed.xyz, contacts.vtp, repose.vtp, repose.xyz, penetration_<plate>.vtp, .xyz and,
/// last, result.json: where it stands, the others are whole. `view_bed` is regolab::view_bed, or a test's.
Result<void> write_outputs(const std::filesystem::path& directory, const Job& job, const JobRun& run,
                           const ViewBed& view_bed, const std::string& case_name);

}  // namespace regolab
