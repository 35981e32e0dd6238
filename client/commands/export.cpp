#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "client/commands/commands.h"
#include "client/csv_write.h"
#include "client/file_write.h"
#include "client/json_view.h"
#include "client/number_text.h"
#include "client/session.h"
#include "vocab/measurement.h"
#include "vocab/plate.h"

namespace regolab::client {
namespace {

namespace fs = std::filesystem;

/// "settle", "fabric", "repose", "stress_2.5kPa", "penetration_30x3mm".
std::string stage_name(const pb::StageSpec& spec) {
  switch (spec.kind()) {
    case pb::STAGE_SETTLE: return "settle";
    case pb::STAGE_FABRIC: return "fabric";
    case pb::STAGE_REPOSE: return "repose";
    case pb::STAGE_STRESS: return "stress_" + shortest(spec.confining_stress_pa() / 1000) + "kPa";
    case pb::STAGE_PENETRATION: return "penetration_" + plate_text({spec.plate_width_m(), spec.plate_thickness_m()});
    default: return "stage";
  }
}

/// A name that is safe as a file's: letters, digits, dot, dash and underscore.
std::string file_name(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '_') c = '_';
  }
  return text;
}

/// What export writes: one folder per point and seed, and two tables over all stages. Times stand in a table of their own,
/// so that two exports of bit-equal studies differ in that file alone.
class ExportFolder {
 public:
  explicit ExportFolder(fs::path folder) : folder_(std::move(folder)) {}

  Outcome add(const pb::ExportItem& item) {
    const std::string name = stage_name(item.spec());
    const fs::path inside = fmt::format("point-{:03}/seed-{}", item.point(), item.seed());
    std::error_code error;
    fs::create_directories(folder_ / inside, error);
    if (error)
      return failed(Exit::kInternal,
                    fmt::format("cannot make {} ({}) choose another place", (folder_ / inside).string(), error.message()));
    if (auto written = write_file(folder_ / inside / (name + ".json"), text_of(json_of(item))); !written.ok())
      return written;
    for (const auto& curve : item.result().curves()) {
      const std::string file = file_name(name + "-" + curve.id() + ".csv");
      if (auto written = write_file(folder_ / inside / file, curve_csv(curve)); !written.ok()) return written;
    }
    const std::string point = std::to_string(item.point());
    const std::string seed = std::to_string(item.seed());
    stages_ += csv_line({point, seed, name, item.state(), std::string(name_of(static_cast<StageEnd>(item.result().end()))),
                         item.result().reason(), item.stage_key(), (inside / (name + ".json")).string()});
    times_ += csv_line({point, seed, name, shortest(item.wall_s()), std::to_string(item.steps())});
    ++count_;
    return done();
  }

  Outcome finish(const pb::ExperimentStatus& status, const pb::ResultsReply& results) {
    if (auto w = write_file(folder_ / "stages.csv", stages_); !w.ok()) return w;
    if (auto w = write_file(folder_ / "times.csv", times_); !w.ok()) return w;
    if (auto w = write_file(folder_ / "results.csv", results_csv(results)); !w.ok()) return w;
    Json design = document("export");
    design["experiment"] = status.experiment();
    design["name"] = status.name();
    design["state"] = status.state();
    design["summary"] = json_of(status.summary());
    return write_file(folder_ / "experiment.json", text_of(design));
  }

  int count() const { return count_; }

 private:
  fs::path folder_;
  std::string stages_ = csv_line({"point", "seed", "stage", "state", "end", "reason", "stage_key", "file"});
  std::string times_ = csv_line({"point", "seed", "stage", "wall_s", "steps"});
  int count_ = 0;
};

Outcome fill(const std::string& id, Session& session, ExportFolder& folder) {
  pb::ExperimentStatus status;
  pb::ResultsReply results;
  if (auto got = session.lab->get(id, status); !got.ok()) return got;
  if (auto got = session.lab->results(id, results); !got.ok()) return got;
  if (auto got = session.lab->export_stages(id, [&](const pb::ExportItem& item) { return folder.add(item); }); !got.ok())
    return got;
  return folder.finish(status, results);
}

}  // namespace

Outcome export_stages(const Arguments& arguments, Console& console) {
  const fs::path target = arguments.output;
  std::error_code error;
  if (fs::exists(target, error)) {
    return failed(
        Exit::kInvalidInput,
        fmt::format("{} exists already (an export is never mixed with other files) choose another -o DIR", target.string()));
  }
  Session session;
  if (auto opened = open_session(arguments, Need::kStored, session); !opened.ok()) return opened;
  std::string id;
  if (auto found = resolve_experiment(*session.lab, arguments, console, id); !found.ok()) return session.explain(found);

  const fs::path part = fmt::format("{}.part-{}", target.string(), getpid());
  fs::create_directories(part, error);
  if (error)
    return failed(Exit::kInternal,
                  fmt::format("cannot make {} ({}) choose another -o DIR", target.string(), error.message()));
  ExportFolder folder(part);
  Outcome outcome = session.explain(fill(id, session, folder));
  if (outcome.ok()) {
    fs::rename(part, target, error);
    if (error)
      outcome = failed(Exit::kInternal,
                       fmt::format("cannot make {} ({}) choose another -o DIR", target.string(), error.message()));
  }
  if (!outcome.ok()) {
    fs::remove_all(part, error);
    return outcome;
  }
  if (arguments.json) {
    Json out = document("export");
    out["experiment"] = id;
    out["folder"] = target.string();
    out["stages"] = folder.count();
    console.out << text_of(out);
    return done();
  }
  console.err << fmt::format(
      "{} stages written to {}: results.csv, stages.csv, times.csv, experiment.json, and a folder per point and seed\n",
      folder.count(), target.string());
  return done();
}

}  // namespace regolab::client
