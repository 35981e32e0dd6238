#include "scheduler/rpc/submission.h"

#include <cctype>

#include "digest/sha256.h"
#include "scheduler/design/design_file.h"
#include "scheduler/design/expand.h"
#include "scheduler/rpc/analysis_convert.h"

namespace regolab {
namespace {

constexpr std::size_t kMostPoints = 4096;
constexpr std::size_t kMostStages = 100'000;

DesignFiles files_of(const v1::SubmitRequest& request) {
  DesignFiles files{request.design_yaml(), request.file_name(), {}};
  for (const auto& [name, bytes] : request.attachments()) files.attachments[name] = bytes;
  return files;
}

void describe(const Design& design, const v1::SubmitRequest& request, ExperimentRecord& record) {
  record.name = design.name;
  record.request_id = request.request_id();
  record.design_yaml = request.design_yaml();
  record.file_name = request.file_name();
  for (const auto& [name, bytes] : request.attachments()) record.attachments[name] = bytes;
  record.array = design.array;
  for (const DesignFactor& factor : design.factors) record.factors.push_back({factor.name, factor.unit, factor.labels});
  for (const DesignPoint& point : design.points) record.levels.push_back(point.level);
  for (const TableResponse& response : responses_of(design)) {
    record.responses.push_back({response.id, response.unit, source_of(response.id).kind});
  }
}

/// Equal digests: the same name, factors, stages and responses, whatever the files look like.
std::string digest_of(const ExperimentRecord& record, const std::vector<Wish>& wishes) {
  Sha256 sum;
  const auto add = [&sum](const std::string& text) { sum.add(std::to_string(text.size()) + ":" + text); };
  add(record.name);
  add(record.array);
  for (const TableFactor& factor : record.factors) {
    add(factor.name), add(factor.unit);
    for (const std::string& label : factor.levels) add(label);
  }
  for (const auto& row : record.levels) {
    for (const int level : row) add(std::to_string(level));
  }
  for (const ResponseRecord& response : record.responses) add(response.id);
  for (const Wish& wish : wishes) add(std::to_string(wish.point)), add(std::to_string(wish.seed)), add(wish.key);
  return sum.hex();
}

void refuse(Submission& submission, const v1::SubmitRequest& request, std::string text) {
  v1::Diagnostic& diagnostic = submission.diagnostics.emplace_back();
  diagnostic.set_file(request.file_name());
  diagnostic.set_text(std::move(text));
}

}  // namespace

Submission prepare(const v1::SubmitRequest& request) {
  Submission out;
  const Read<Design> read = read_design(files_of(request), {request.profile(), request.seeds()});
  for (const Diagnostic& diagnostic : read.diagnostics) out.diagnostics.push_back(to_proto(diagnostic));
  if (!read.ok()) return out;
  const Design& design = *read.value;
  const std::size_t per_point = design.seeds.size() * stages_per_run(design);
  if (design.points.size() > kMostPoints || design.points.size() * per_point > kMostStages) {
    refuse(out, request,
           "the study has " + std::to_string(design.points.size()) + " points and " +
               std::to_string(design.points.size() * per_point) + " stages (at most " + std::to_string(kMostPoints) +
               " and " + std::to_string(kMostStages) + "), split it or use fewer seeds");
    return out;
  }
  out.summary = to_proto(design);
  describe(design, request, out.record);
  for (const DesignPoint& point : design.points) {
    for (const std::uint64_t seed : seeds_of(design, point)) {
      std::string settle_key;
      for (const StageSpec& spec : expand(design, point, seed)) {
        Wish wish{point.point, seed, spec, stage_key(spec), {}};
        if (needs_bed(spec.kind))
          wish.parent_key = settle_key;
        else
          settle_key = wish.key;
        out.wishes.push_back(std::move(wish));
      }
    }
  }
  out.record.digest = digest_of(out.record, out.wishes);
  if (out.record.request_id.empty()) out.record.request_id = out.record.digest;
  return out;
}

std::string label_of(const std::string& name, const std::string& digest) {
  std::string label;
  for (const char c : name.substr(0, 40)) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!label.empty() && label.back() != '-')
      label += '-';
  }
  if (!label.empty() && label.back() != '-') label += '-';
  return label + digest.substr(0, 6);
}

}  // namespace regolab
