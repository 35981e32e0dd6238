#include "scheduler/rpc/blind.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "scheduler/gap/bank_in_use.h"
#include "scheduler/gap/blind/draw.h"
#include "scheduler/gap/blind/parts.h"
#include "scheduler/gap/blind/record.h"
#include "scheduler/gap/blind/report_case.h"
#include "scheduler/gap/blind/true_gap.h"
#include "scheduler/gap/observation_file.h"
#include "scheduler/rpc/grpc_status.h"
#include "store/reader.h"

namespace regolab {
namespace {

constexpr std::size_t kSecretBytes = 32;
constexpr std::uint32_t kMostCases = 100000;

/// What one design's stages gave to the specimens of a case. `needed` counts stages that measure.
struct Gathering {
  std::map<std::uint64_t, gap::SpecimenRecord> specimens;  // by seed
  std::uint32_t needed = 0, found = 0;

  Result<void> add(Reader& reader, const gap::BlindPart& part, const std::string& experiment) {
    const auto design = reader.design(experiment);
    if (!design.ok()) return design.error();
    const auto stages = reader.stages(design->id);
    if (!stages.ok()) return stages.error();
    for (const StoredStage& stage : *stages) {
      const StageSpec& spec = stage.record.identity.spec;
      gap::SpecimenRecord& record = specimens[stage.link.seed];
      const bool wanted = spec.kind == StageKind::kStress || (part.bed && (spec.kind == StageKind::kFabric || spec.kind == StageKind::kRepose));
      if (!wanted) continue;
      ++needed;
      if (stage.record.status.end != StageEnd::kCompleted) continue;
      auto result = reader.result(stage.link.job);
      if (!result.ok()) return result.error();
      ++found;
      if (spec.kind == StageKind::kFabric) record.fabric = std::move(*result);
      if (spec.kind == StageKind::kRepose) record.repose = std::move(*result);
      for (const gap::StressLevel& level : part.stress) {
        if (spec.kind == StageKind::kStress && std::abs(level.applied - spec.confining_stress) < 0.5)
          record.stress[level.said] = gap::relabelled(*result, level.applied, level.said);
      }
    }
    return {};
  }
};

std::optional<gap::MeasuredShrinkage> shrinkage_of(const std::string& text) {
  const auto j = nlohmann::json::parse(text, nullptr, false);
  if (!j.is_object() || !j.contains("S") || !j["S"].is_number()) return std::nullopt;
  return gap::MeasuredShrinkage{j["S"], j.value("q05", NAN), j.value("q95", NAN)};
}

}  // namespace

grpc::Status BlindService::Draw(grpc::ServerContext*, const v1::BlindDrawRequest* request, v1::BlindDrawReply* reply) {
  if (request->secret().size() != kSecretBytes) return to_grpc(invalid("secret (must be 32 bytes) draw it from the system's entropy"));
  if (request->specimens() < 1 || request->specimens() > 100) return to_grpc(invalid("specimens (must be 1 to 100) take 3"));
  if (request->cases() > kMostCases || request->nulls() > kMostCases) return to_grpc(invalid("cases (at most 100000) ask for fewer"));
  const gap::BlindPlan plan{.cases = static_cast<int>(request->cases()),
                            .nulls = static_cast<int>(request->nulls()),
                            .specimens = static_cast<int>(request->specimens()),
                            .development = request->development()};
  const gap::BankInUse bank = gap::bank_in_use("", "", "");
  if (!bank.emulator().ok()) return to_grpc(bank.emulator().error());
  const auto sight = [&](const gap::Truth& truth) { return gap::expected_isolability(*bank.emulator(), truth).value_or(0); };
  for (const gap::Truth& truth : gap::draw_truths(plan, request->secret(), sight)) {
    auto& out = *reply->add_truths();
    out.set_id(truth.id), out.set_text(gap::truth_text(truth));
  }
  return grpc::Status::OK;
}

grpc::Status BlindService::Design(grpc::ServerContext*, const v1::BlindTruth* request, v1::BlindDesignReply* reply) {
  const auto truth = gap::truth_from(request->text());
  if (!truth.ok()) return to_grpc(truth.error());
  for (std::size_t part = 0; part < gap::parts_of(*truth).size(); ++part) {
    const gap::BlindDesign design = gap::design_of(*truth, part);
    auto& out = *reply->add_designs();
    out.set_file_name("case.yaml");
    out.set_design_yaml(design.yaml);
    (*out.mutable_attachments())["case.csv"] = design.table;
  }
  return grpc::Status::OK;
}

grpc::Status BlindService::Observe(grpc::ServerContext*, const v1::BlindObserveRequest* request, v1::BlindObserveReply* reply) {
  const auto truth = gap::truth_from(request->truth().text());
  if (!truth.ok()) return to_grpc(truth.error());
  const auto parts = gap::parts_of(*truth);
  if (static_cast<std::size_t>(request->experiments_size()) != parts.size())
    return to_grpc(invalid("experiments (one for each design of the case) hand in all of them"));
  auto reader = Reader::open(database_);
  if (!reader.ok()) return to_grpc(reader.error());
  Gathering gathered;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (auto added = gathered.add(*reader, parts[part], request->experiments(static_cast<int>(part))); !added.ok()) return to_grpc(added.error());
  }
  std::vector<gap::SpecimenRecord> specimens;
  for (auto& [seed, record] : gathered.specimens) {
    gap::misrecord(*truth, record);
    specimens.push_back(std::move(record));
  }
  reply->set_file(gap::observations_yaml(gap::observation_of(*truth, specimens)));
  reply->set_stages(gathered.needed), reply->set_without_numbers(gathered.needed - gathered.found);
  return grpc::Status::OK;
}

grpc::Status BlindService::Score(grpc::ServerContext*, grpc::ServerReader<v1::BlindScoreRequest>* reader, v1::BlindScoreReply* reply) {
  v1::BlindScoreRequest message;
  if (!reader->Read(&message)) return to_grpc(invalid("no bank (the first message names it) send one, if an empty one"));
  const auto missing = static_cast<int>(message.missing());
  const gap::BankInUse bank = gap::bank_in_use(message.bank_name(), message.bank_csv(), message.kernels_json());
  if (!bank.diagnostics.empty()) return to_grpc(invalid(to_text(bank.diagnostics.front())));
  const bool emulated = bank.emulator().ok();
  if (!emulated) reply->add_warnings("isolability and moved groups are not known: " + bank.emulator().error().text);
  std::vector<gap::Mark> marks;
  while (reader->Read(&message)) {
    const auto truth = gap::truth_from(message.truth());
    if (!truth.ok()) return to_grpc(truth.error());
    const auto answer = gap::answer_from(message.answer());
    if (!answer.ok()) return to_grpc(answer.error());
    const auto set = gap::read_observations(truth->id, message.observations(), gap::MissingErrors::kAssume);
    const auto gap = emulated && set.ok() ? gap::true_gap(*bank.emulator(), *set.value, *truth) : std::nullopt;
    marks.push_back(gap::mark_of(*truth, *answer, gap, shrinkage_of(message.shrinkage())));
  }
  const gap::Score score = gap::score_of(marks, missing);
  reply->set_record_csv(gap::record_csv(marks)), reply->set_score_json(gap::score_json(score)), reply->set_text(gap::score_text(score));
  return grpc::Status::OK;
}

}  // namespace regolab
