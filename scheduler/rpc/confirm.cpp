/// Confirmation: what is to be run, and what the runs say.
#include <algorithm>
#include <cmath>
#include <span>

#include "scheduler/gap/fit.h"
#include "scheduler/gap/held_out.h"
#include "scheduler/gap/shrinkage.h"
#include "scheduler/rpc/confirmation.h"
#include "scheduler/rpc/diagnosis_book.h"
#include "scheduler/rpc/gap_convert.h"
#include "scheduler/rpc/gaps.h"
#include "scheduler/rpc/grpc_status.h"
#include "scheduler/rpc/submission.h"

namespace regolab {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFewNumbers = 0.5;  // share of runs without a number that is worth a warning

/// A finished diagnosis with what it was made from.
struct Confirmed {
  v1::Diagnosis diagnosis;
  gap::ObservationSet set;
};

Result<Confirmed> confirmed(Reader& reader, const std::string& id) {
  const auto record = reader.diagnosis(id);
  if (!record.ok()) return record.error();
  if (!record->ended_ms) return Error{Code::kFailedPrecondition, "diagnosis " + id + " has not ended (stopped, or under way) let it end first"};
  auto diagnosis = stored_diagnosis(reader, *record);
  if (!diagnosis.ok()) return diagnosis.error();
  v1::ImportRequest file;
  if (!file.ParseFromString(record->measurements)) return Error{Code::kDataLoss, "the stored measurements cannot be read (damaged) diagnose the file again"};
  auto set = read_measurements_of(file);
  if (!set.ok()) return Error{Code::kDataLoss, "the stored measurements are refused (of another version) diagnose the file again"};
  return Confirmed{std::move(*diagnosis), std::move(*set.value)};
}

/// A round of runs as the store has it: features of each row, base first.
Result<std::vector<std::map<std::string, double>>> features_of_round(Reader& reader, const std::string& label) {
  const auto design = reader.design(label);
  if (!design.ok()) return design.error();
  const auto stages = reader.stages(design->id);
  if (!stages.ok()) return stages.error();
  std::map<std::pair<int, std::uint64_t>, gap::Readings> readings;  // rows are points; of one point, seeds
  for (const StoredStage& stage : *stages) {
    gap::Readings& row = readings[{stage.link.point, stage.link.seed}];
    if (stage.record.identity.spec.kind == StageKind::kSettle || stage.record.status.end != StageEnd::kCompleted) continue;
    const auto result = reader.result(stage.link.job);
    if (!result.ok()) return result.error();
    gap::add_readings(*result, row);
  }
  std::vector<std::map<std::string, double>> out;
  for (const auto& [at, row] : readings) {
    auto& features = out.emplace_back();
    for (const gap::Feature& f : gap::features_of(row)) features[f.id] = f.value;
  }
  return out;
}

/// [q][n] of the held-out features, as specimens of the bank's size measure them; NaN where a run has no number.
struct Runs {
  MatrixXd base, repaired;
  std::vector<std::string> experiments;
};

/// model: of the rows, whose first is its draw `draw`. size_shift: what specimens of the runs' size measure, less those of the bank's. [q]
void append(std::span<const std::map<std::string, double>> rows, const v1::WeighedModel* model, int draw, const gap::Comparison& held, const VectorXd& size_shift,
            MatrixXd& runs) {
  for (const auto& row : rows) {
    const double strength = model && model->strength_size() > 0 ? model->draws(draw++).strengths_si(0) : 0;
    runs.conservativeResize(held.size(), runs.cols() + 1);
    for (Index f = 0; f < held.size(); ++f) {
      const std::string& id = held.measured[static_cast<std::size_t>(f)].id;
      const auto found = row.find(id);
      const double shown = model ? gap::read_by_gauge(model->model(), strength, *gap::feature_info(id)) : 0;
      runs(f, runs.cols() - 1) = found == row.end() ? NAN : found->second + shown - size_shift[f];
    }
  }
}

/// In specimens of the size that was measured.
gap::Level level_of(const MatrixXd& runs, const gap::Comparison& held, Index feature, std::uint32_t& count) {
  std::vector<double> v;
  for (Index r = 0; r < runs.cols(); ++r) {
    if (std::isfinite(runs(feature, r))) v.push_back(runs(feature, r));
  }
  count = static_cast<std::uint32_t>(v.size());
  if (v.empty()) return {NAN, NAN};
  const Eigen::Map<const VectorXd> all(v.data(), std::ssize(v));
  const double n = static_cast<double>(v.size()), mean = all.mean();
  return {mean + held.size_shift[feature], n > 1 ? std::sqrt((all.array() - mean).square().sum() / (n - 1) / n) : 0};
}

void add_features(const gap::Comparison& held, const Runs& runs, v1::Shrinkage& out) {
  std::size_t missing = 0;
  for (Index f = 0; f < held.size(); ++f) {
    std::uint32_t before = 0, after = 0;
    gap::FeatureFit fit{.measured = held.measured[static_cast<std::size_t>(f)], .base = level_of(runs.base, held, f, before), .repaired = {}};
    if (runs.repaired.cols() > 0) fit.repaired = level_of(runs.repaired, held, f, after);
    if (before == 0 || (fit.repaired && after == 0)) {
      out.add_warnings(fit.measured.id + " takes no part: no run measured it");
      continue;
    }
    v1::FittedFeature& one = *out.add_features();
    one = to_proto(fit);
    one.set_held_out(true), one.set_base_runs(before), one.set_repaired_runs(after);
    missing += static_cast<std::size_t>(runs.base.cols() + runs.repaired.cols()) - before - after;
  }
  const double all = static_cast<double>(held.size() * (runs.base.cols() + runs.repaired.cols()));
  if (static_cast<double>(missing) > kFewNumbers * all) out.add_warnings("more than half of the runs ended without numbers: what is left may not stand for them");
}

double root(double squared) { return std::sqrt(std::max(0.0, squared)); }

/// The emulator's means at the same draws, taken as runs.
std::optional<double> promised(const gap::Emulator& emulator, const gap::Comparison& held, const gap::Target& target, const v1::Diagnosis& d, Index draws) {
  const v1::WeighedModel* repaired = repaired_model(d);
  const auto means = [&](const std::string& name) {
    gap::Weighed model{.model = name, .cause = {}, .strength = {}, .draws = {}};
    const auto found = std::ranges::find_if(d.models(), [&](const auto& m) { return m.model() == name; });
    for (const auto& s : found->strength()) model.strength.push_back({.effect = s.effect(), .unit = s.unit_si()});
    for (const auto& draw : found->draws()) {
      if (std::ssize(model.draws) < draws) model.draws.push_back({{draw.values_si().begin(), draw.values_si().end()}, {draw.strengths_si().begin(), draw.strengths_si().end()}});
    }
    return gap::emulated(emulator, model, held.feature).mean;
  };
  if (!repaired) return std::nullopt;
  return gap::shrinkage_of(target, means("none"), means(repaired->model()), d.first_seed()).s;
}

v1::Shrinkage measured(const gap::Emulator& emulator, const gap::Comparison& held, const v1::Diagnosis& d, const Runs& runs) {
  v1::Shrinkage out;
  out.set_diagnosis(d.id()), out.set_model(d.repaired()), out.set_draws(static_cast<std::uint32_t>(runs.base.cols()));
  for (const std::string& group : d.held_out()) out.add_heldout(group);
  for (const std::string& label : runs.experiments) out.add_experiments(label);
  add_features(held, runs, out);
  if (out.features().empty()) {
    out.set_undefined("no run of either model has a held-out number (see the stages of its experiments)");
    return out;
  }
  const gap::Target target{held.y, held.covariance(MatrixXd(MatrixXd::Zero(held.size(), held.size())))};
  const bool repaired = runs.repaired.cols() > 0;
  const gap::SquaredGap base = gap::squared_gap(target, runs.base, d.first_seed());
  out.set_base_gap(root(base.value)), out.set_base_gap_noise_95(root(base.noise_95));
  if (!repaired) {
    out.set_undefined("no effect was named, so nothing was repaired: only the base model's gap is measured");
    return out;
  }
  const gap::Shrinkage shrinkage = gap::shrinkage_of(target, runs.base, runs.repaired, d.first_seed());
  out.set_repaired_gap(root(shrinkage.repaired.value));
  if (shrinkage.s) out.set_s(*shrinkage.s);
  else out.set_undefined("the re-calibrated base model's gap on the held-out measurements is within noise: there is nothing to shrink");
  if (shrinkage.low) out.set_q05(*shrinkage.low);
  if (shrinkage.high) out.set_q95(*shrinkage.high);
  if (const auto s = promised(emulator, held, target, d, runs.base.cols())) out.set_emulator_s(*s);
  return out;
}

}  // namespace

grpc::Status GapsService::PlanConfirmation(grpc::ServerContext*, const v1::PlanRequest* request, v1::PlanReply* reply) {
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const auto known = confirmed(*reader, request->diagnosis());
  if (!known.ok()) return to_grpc(known.error());
  const auto design = confirmation_design(known->diagnosis, known->set, static_cast<int>(request->first()), static_cast<int>(request->draws()));
  if (!design.ok()) return to_grpc(design.error());
  *reply->mutable_design() = *design;
  const Submission submission = prepare(*design);
  if (!submission.diagnostics.empty()) return to_grpc({Code::kFailedPrecondition, submission.diagnostics.front().text()});
  return to_grpc(desk_.ask(Desk::Need::kRead, [&](Desk::Turn& turn) -> Result<void> {
    std::uint32_t stored = 0, left = 0;
    double core_s = 0;
    for (const Wish& wish : submission.wishes) {
      const JobQueue::Job* job = turn.queue.find_key(wish.key);
      if (job && job->status.state == JobState::kSucceeded) {
        ++stored;
        continue;
      }
      if (wish.spec.kind == StageKind::kFabric) continue;
      ++left;
      const auto expected = turn.book.expected_s(wish.spec);
      core_s = !expected || core_s < 0 ? -1 : core_s + *expected;
    }
    reply->set_dem_jobs(left), reply->set_jobs_stored(stored), reply->set_core_s(core_s);
    return {};
  }));
}

grpc::Status GapsService::MeasureShrinkage(grpc::ServerContext* context, const v1::ShrinkageRequest* request, v1::StoredDiagnosis* reply) {
  v1::DiagnoseRequest of = request->of();
  of.set_hold_out(true);
  v1::DiagnoseEvent event;
  const auto question = read(of, event);
  if (!question.ok()) return to_grpc(question.error());
  if (!*question) return to_grpc(invalid("the measurements or the bank are refused (see `regolab gap diagnose`) correct them"));
  const Question& q = **question;
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  const std::string id = diagnosis_record(of, q.bank, q.set.name, gap::held_out_text(q.held_out)).id;
  const auto known = confirmed(*reader, id);
  if (!known.ok()) return to_grpc(known.error());
  const gap::Comparison all = gap::compare(*q.bank.emulator, q.set);
  std::vector<Index> at;
  for (Index k = 0; k < all.size(); ++k) {
    if (std::ranges::find(q.held_out, all.measured[static_cast<std::size_t>(k)].group.sigma3) != q.held_out.end()) at.push_back(k);
  }
  const gap::Comparison held = all.subset(at);
  Runs runs{.base = MatrixXd(held.size(), 0), .repaired = MatrixXd(held.size(), 0), .experiments = {}};
  const VectorXd size_shift = runs_measured_size(q.set) ? held.size_shift : VectorXd::Zero(held.size());
  int first = 0;
  for (const std::uint32_t draws : request->rounds()) {
    const auto design = confirmation_design(known->diagnosis, known->set, first, static_cast<int>(draws));
    if (!design.ok()) return to_grpc(design.error());
    const std::string digest = prepare(*design).record.digest;
    std::string label;
    const auto asked = desk_.ask(Desk::Need::kRead, [&](Desk::Turn& turn) -> Result<void> {
      const ExperimentRecord* record = turn.book.find_digest(digest);
      if (!record) return Error{Code::kFailedPrecondition, "the runs are not there (round of draw " + std::to_string(first + 1) + " was never submitted) submit what PlanConfirmation gives"};
      label = record->label;
      return {};
    });
    if (!asked.ok()) return to_grpc(asked.error());
    const auto rows = features_of_round(*reader, label);
    if (!rows.ok()) return to_grpc(rows.error());
    const std::span all_rows(*rows);
    if (all_rows.size() < draws) return to_grpc({Code::kFailedPrecondition, "runs are missing (experiment " + label + " has fewer rows than draws) submit it again"});
    append(all_rows.first(draws), nullptr, first, held, size_shift, runs.base);
    append(all_rows.subspan(draws), repaired_model(known->diagnosis), first, held, size_shift, runs.repaired);
    runs.experiments.push_back(label);
    first += static_cast<int>(draws);
  }
  const std::string json = json_of(measured(*q.bank.emulator, held, known->diagnosis, runs));
  const auto kept = desk_.ask(Desk::Need::kWrite, [&](Desk::Turn& turn) -> Result<void> {
    if (auto begun = turn.begin(); !begun.ok()) return begun;
    return turn.store.set_shrinkage(id, json);
  });
  if (!kept.ok()) return to_grpc(kept.error());
  v1::GetDiagnosisRequest get;
  get.set_id(id);
  return GetDiagnosis(context, &get, reply);
}

}  // namespace regolab
