#include "worker/output/output_files.h"

#include "worker/output/atomic_file.h"
#include "worker/output/csv_write.h"
#include "worker/output/observations_write.h"
#include "worker/output/result_json.h"
#include "worker/output/vtp_write.h"
#include "worker/output/xyz_write.h"

namespace regolab {
namespace {

namespace fs = std::filesystem;

Result<void> write_curves(const fs::path& folder, const JobRun& run) {
  if (auto made = make_writable_folder(folder); !made) return made;
  for (const KeptStage& kept : run.stages) {
    for (const Curve& curve : kept.stage.result.curves) {
      if (auto written = write_whole_file(folder / (curve.id + ".csv"), curve_csv(curve)); !written) return written;
    }
  }
  return {};
}

Result<void> write_pictures(const fs::path& directory, const JobRun& run, const ViewBed& view_bed) {
  for (const KeptStage& kept : run.stages) {
    if (kept.state.empty()) continue;
    const auto view = view_bed(kept.state);
    if (!view) return view.error();
    const bool settled = kept.stage.spec.kind == StageKind::kSettle;
    std::string name = settled ? "bed" : stage_name(kept.stage.spec.kind);
    if (kept.stage.spec.kind == StageKind::kPenetration) name += "_" + plate_text(kept.stage.spec.plate);
    if (auto written = write_whole_file(directory / (name + ".vtp"), bed_vtp(*view)); !written) return written;
    if (auto written = write_whole_file(directory / (name + ".xyz"), bed_xyz(*view)); !written) return written;
    if (!settled) continue;
    if (auto written = write_whole_file(directory / "contacts.vtp", contacts_vtp(*view)); !written) return written;
  }
  return {};
}

}  // namespace

Result<void> write_outputs(const fs::path& directory, const Job& job, const JobRun& run, const ViewBed& view_bed,
                           const std::string& case_name) {
  std::vector<FinishedStage> stages;
  for (const KeptStage& kept : run.stages) stages.push_back(kept.stage);
  if (auto written = write_curves(directory / "curves", run); !written) return written;
  if (auto written = write_pictures(directory, run, view_bed); !written) return written;
  const std::string observations = observations_yaml(job, stages, case_name);
  if (auto written = write_whole_file(directory / "observations.yaml", observations); !written) return written;
  return write_whole_file(directory / "result.json", result_json(job, stages));
}

}  // namespace regolab
