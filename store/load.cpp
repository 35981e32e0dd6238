#include <algorithm>

#include "store/job_row.h"
#include "store/store.h"

namespace regolab {
namespace {

template <class Names>
int index_of(const Names& names, std::string_view name) {
  return static_cast<int>(std::find(std::begin(names), std::end(names), name) - std::begin(names));
}

StageKind kind_of(std::string_view name) {
  for (const StageKind kind : {StageKind::kFabric, StageKind::kRepose, StageKind::kStress, StageKind::kPenetration}) {
    if (name == name_of(kind)) return kind;
  }
  return StageKind::kSettle;
}

Micro read_micro(const Statement& s, int c) {
  return {.friction_angle = s.real(c),
          .normal_stiffness = s.real(c + 1),
          .normal_damping = s.real(c + 2),
          .tangential_stiffness = s.real(c + 3),
          .tangential_damping = s.real(c + 4),
          .largest_diameter = s.real(c + 5),
          .kind = static_cast<ParticleKind>(s.integer(c + 6)),
          .rotation = static_cast<Rotation>(s.integer(c + 7)),
          .damping_unit = static_cast<DampingUnit>(s.integer(c + 8)),
          .grain_density = s.real(c + 9),
          .gravity = s.real(c + 10)};
}

Numerics read_numerics(const Statement& s, int c) {
  return {.clusters = static_cast<int>(s.integer(c)),
          .box_length = s.real(c + 1),
          .box_width = s.real(c + 2),
          .settle_stiffness_number = s.real(c + 3),
          .stress_stiffness_number = s.real(c + 4),
          .mass_floor = s.real(c + 5),
          .step_fraction = s.real(c + 6),
          .inertial_number = s.real(c + 7),
          .axial_strain = s.real(c + 8)};
}

}  // namespace

JobRecord read_job(const Statement& s, int c) {
  JobRecord record;
  record.identity.id = JobId{static_cast<std::uint64_t>(s.integer(c))};
  record.identity.key = s.text(c + 1);
  record.identity.parent = JobId{static_cast<std::uint64_t>(s.integer(c + 3))};
  record.identity.spec = {.kind = kind_of(s.text(c + 2)),
                          .micro = read_micro(s, c + 6),
                          .numerics = read_numerics(s, c + 17),
                          .seed = static_cast<std::uint64_t>(s.integer(c + 4)),
                          .confining_stress = s.real(c + 5),
                          .plate = {.width = s.real(c + 40), .thickness = s.real(c + 41)}};
  record.identity.spec.numerics.most_damping_ratio = s.real(c + 39);
  record.identity.spec.numerics.isotropic_servo_steps = s.real(c + 43);
  record.identity.spec.effects = effects_from_text(s.text(c + 42)).value_or(EffectSet{});
  JobStatus& status = record.status;
  status.state = static_cast<JobState>(index_of(kJobStateNames, s.text(c + 26)));
  status.token = LeaseToken{static_cast<std::uint64_t>(s.integer(c + 27))};
  status.worker = s.text(c + 28);
  status.attempts = static_cast<int>(s.integer(c + 29));
  status.deaths = static_cast<int>(s.integer(c + 30));
  status.deaths_anywhere = static_cast<int>(s.integer(c + 31));
  status.death_steps = static_cast<std::uint64_t>(s.integer(c + 32));
  status.detail = s.text(c + 33);
  status.bed = s.text(c + 34);
  status.checkpoint = s.text(c + 35);
  if (!s.null(c + 36)) status.end = static_cast<StageEnd>(s.integer(c + 36));
  status.wall_s = s.real(c + 37);
  status.steps = static_cast<std::uint64_t>(s.integer(c + 38));
  return record;
}

Result<Snapshot> Store::load() {
  Snapshot snapshot;
  {
    Statement s = db_.prepare("SELECT " REGOLAB_JOB_COLUMNS " FROM job j LEFT JOIN result r ON r.job = j.id ORDER BY j.id");
    while (s.step()) snapshot.jobs.push_back(read_job(s, 0));
    if (auto end = s.end("read the jobs"); !end.ok()) return end.error();
  }
  {
    Statement s = db_.prepare(
        "SELECT id, label, name, request_id, digest, file_name, array, summary, state, created_ms, ended_ms, "
        "1 + coalesce((SELECT max(seq) FROM event WHERE experiment = id), 0) FROM experiment ORDER BY id");
    while (s.step()) {
      Snapshot::Study study;
      ExperimentRecord& r = study.record;
      r.id = ExperimentId{static_cast<std::uint64_t>(s.integer(0))};
      r.label = s.text(1), r.name = s.text(2), r.request_id = s.text(3), r.digest = s.text(4), r.file_name = s.text(5);
      r.array = s.text(6), r.summary = s.text(7);
      r.state = static_cast<ExperimentState>(index_of(kExperimentStateNames, s.text(8)));
      r.created_ms = s.integer(9);
      if (!s.null(10)) r.ended_ms = s.integer(10);
      study.next_seq = static_cast<std::uint64_t>(s.integer(11));
      snapshot.studies.push_back(std::move(study));
    }
    if (auto end = s.end("read the experiments"); !end.ok()) return end.error();
  }
  Statement s = db_.prepare("SELECT experiment, job, point, seed, reused FROM experiment_job ORDER BY experiment, n");
  while (s.step()) {
    snapshot.links.push_back({ExperimentId{static_cast<std::uint64_t>(s.integer(0))},
                              JobId{static_cast<std::uint64_t>(s.integer(1))}, static_cast<int>(s.integer(2)),
                              static_cast<std::uint64_t>(s.integer(3)), s.integer(4) != 0});
  }
  if (auto end = s.end("read the links"); !end.ok()) return end.error();
  return snapshot;
}

}  // namespace regolab
