#include "store/reader.h"

#include "store/exact.h"
#include "store/job_row.h"

namespace regolab {

Result<Reader> Reader::open(const std::string& path) {
  auto db = Database::open(path, Access::kRead);
  if (!db.ok()) return db.error();
  return Reader{std::move(*db)};
}

Result<ExperimentRecord> Reader::design(const std::string& label) {
  ExperimentRecord r;
  {
    Statement s = db_.prepare("SELECT id, name, array, digest FROM experiment WHERE label = ?");
    if (!s.bind(label).step()) {
      return Error{Code::kNotFound,
                   "experiment '" + label + "' is not known here (not in this database), list them with `regolab status`"};
    }
    r.id = ExperimentId{static_cast<std::uint64_t>(s.integer(0))};
    r.label = label, r.name = s.text(1), r.array = s.text(2), r.digest = s.text(3);
  }
  const auto id = static_cast<std::uint64_t>(r.id);
  {
    Statement s = db_.prepare(
        "SELECT f.n, f.name, f.unit, l.label FROM factor f LEFT JOIN level l ON l.experiment = f.experiment AND l.factor = "
        "f.n "
        "WHERE f.experiment = ? ORDER BY f.n, l.n");
    for (s.bind(id); s.step();) {
      if (static_cast<std::size_t>(s.integer(0)) == r.factors.size()) r.factors.push_back({s.text(1), s.text(2), {}});
      if (!s.null(3)) r.factors.back().levels.push_back(s.text(3));
    }
  }
  {
    Statement s = db_.prepare("SELECT point, level FROM point_level WHERE experiment = ? ORDER BY point, factor");
    for (s.bind(id); s.step();) {
      r.levels.resize(static_cast<std::size_t>(s.integer(0)));
      r.levels.back().push_back(static_cast<int>(s.integer(1)));
    }
  }
  Statement s = db_.prepare("SELECT id, unit_si, stage FROM response WHERE experiment = ? ORDER BY n");
  for (s.bind(id); s.step();) {
    const std::string stage = s.text(2);
    StageKind kind = StageKind::kSettle;
    for (const StageKind k : {StageKind::kFabric, StageKind::kRepose, StageKind::kStress, StageKind::kPenetration}) {
      if (stage == name_of(k)) kind = k;
    }
    r.responses.push_back({s.text(0), s.text(1), kind});
  }
  if (auto end = s.end("read the design"); !end.ok()) return end.error();
  return r;
}

Result<std::vector<StoredStage>> Reader::stages(ExperimentId id) {
  std::vector<StoredStage> stages;
  Statement s = db_.prepare("SELECT e.job, e.point, e.seed, e.reused, r.stage_end_name, " REGOLAB_JOB_COLUMNS
                            " FROM experiment_job e JOIN job j ON j.id = e.job LEFT JOIN result r ON r.job = j.id "
                            "WHERE e.experiment = ? ORDER BY e.n");
  for (s.bind(static_cast<std::uint64_t>(id)); s.step();) {
    StoredStage stage;
    stage.link = {id, JobId{static_cast<std::uint64_t>(s.integer(0))}, static_cast<int>(s.integer(1)),
                  static_cast<std::uint64_t>(s.integer(2)), s.integer(3) != 0};
    if (!s.null(4)) stage.end_name = s.text(4);
    stage.record = read_job(s, 5);
    stages.push_back(std::move(stage));
  }
  if (auto end = s.end("read the stages"); !end.ok()) return end.error();
  return stages;
}

Result<std::vector<StoredResponse>> Reader::responses(ExperimentId id) {
  std::vector<StoredResponse> responses;
  Statement s = db_.prepare(
      "SELECT e.point, e.seed, m.id, m.value_si, m.value_bits FROM experiment_job e JOIN result r ON r.job = e.job AND "
      "r.stage_end = 0 "
      "JOIN measurement m ON m.job = e.job AND m.role = 'response' WHERE e.experiment = ?");
  for (s.bind(static_cast<std::uint64_t>(id)); s.step();) {
    responses.push_back(
        {static_cast<int>(s.integer(0)), static_cast<std::uint64_t>(s.integer(1)), s.text(2), read_exact(s, 3).value_or(0)});
  }
  if (auto end = s.end("read the responses"); !end.ok()) return end.error();
  return responses;
}

Result<StageResult> Reader::result(JobId job) {
  StageResult result;
  {
    Statement s = db_.prepare("SELECT stage_end, reason FROM result WHERE job = ?");
    if (!s.bind(static_cast<std::uint64_t>(job)).step()) return Error{Code::kNotFound, "the job has no result yet"};
    result.end = static_cast<StageEnd>(s.integer(0));
    result.reason = s.text(1);
  }
  {
    Statement s = db_.prepare(
        "SELECT role, id, value_si, value_bits, unit_si, standard_error_si, standard_error_bits, definition FROM "
        "measurement "
        "WHERE job = ? ORDER BY role, n");
    for (s.bind(static_cast<std::uint64_t>(job)); s.step();) {
      auto& list = s.text(0) == "response" ? result.measurements : result.numerics;
      list.push_back({s.text(1), read_exact(s, 2).value_or(0), s.text(4), read_exact(s, 5), s.text(7)});
    }
    if (auto end = s.end("read the measurements"); !end.ok()) return end.error();
  }
  if (auto curves = read_curves(job, result); !curves.ok()) return curves.error();
  return result;
}

Result<void> Reader::read_curves(JobId job, StageResult& result) {
  {
    Statement s = db_.prepare("SELECT id, test, x_name, x_unit_si, y_name, y_unit_si FROM curve WHERE job = ? ORDER BY n");
    for (s.bind(static_cast<std::uint64_t>(job)); s.step();) {
      result.curves.push_back({s.text(0), s.text(1), s.text(2), s.text(3), s.text(4), s.text(5), {}, {}});
    }
    if (auto end = s.end("read the curves"); !end.ok()) return end;
  }
  Statement s = db_.prepare("SELECT curve, x_si, x_bits, y_si, y_bits FROM curve_point WHERE job = ? ORDER BY curve, n");
  for (s.bind(static_cast<std::uint64_t>(job)); s.step();) {
    Curve& curve = result.curves.at(static_cast<std::size_t>(s.integer(0)));
    if (const auto x = read_exact(s, 1)) curve.x.push_back(*x);
    if (const auto y = read_exact(s, 3)) curve.y.push_back(*y);
  }
  return s.end("read the curves");
}

Result<std::vector<ModelRecord>> Reader::models() {
  std::vector<ModelRecord> models;
  Statement s = db_.prepare("SELECT id, name, created_ms FROM model ORDER BY created_ms DESC, id");
  while (s.step()) models.push_back({s.text(0), s.text(1), s.integer(2), ""});
  if (auto end = s.end("read the models"); !end.ok()) return end.error();
  return models;
}

Result<ModelRecord> Reader::model(const std::string& id) {
  Statement s = db_.prepare("SELECT id, name, created_ms, file FROM model WHERE substr(id, 1, length(?1)) = ?1 ORDER BY created_ms DESC");
  if (!s.bind(id).step()) {
    return Error{Code::kNotFound, "model '" + id + "' is not known here (not in this database), list them with `regolab models`"};
  }
  return ModelRecord{s.text(0), s.text(1), s.integer(2), s.text(3)};
}

}  // namespace regolab
