#include "scheduler/design/expand.h"

#include <charconv>
#include <cmath>

#include "input/number_text.h"

namespace regolab {
namespace {

constexpr std::string_view kSigma3Mark = "_at_sigma3_";
constexpr std::string_view kCompressed = "void_ratio_compressed_";
constexpr std::string_view kPlateMark = "_plate_";

/// "1.25kPa", whole pascals, as in the observation ids.
std::string kpa(double pascal) { return number_text(std::round(pascal) / 1000) + "kPa"; }

void add_fabric(std::vector<TableResponse>& responses, bool primary) {
  if (primary) {
    responses.insert(responses.end(), {{"contacts_per_particle", "1"}, {"bulk_density", "kg/m3"}, {"void_ratio", "1"}});
  } else {
    responses.insert(responses.end(), {{"contacts_without_rattlers", "1"},
                                       {"neighbours_per_particle", "1"},
                                       {"rattler_share", "1"},
                                       {"bulk_density_Hmax", "kg/m3"},
                                       {"core_density", "kg/m3"}});
  }
}

void add_stress(std::vector<TableResponse>& responses, double stress) {
  const std::string at = std::string(kSigma3Mark) + kpa(stress);
  responses.push_back({"sigma1_peak" + at, "Pa"});
  responses.push_back({"sigma1_0.10_0.20" + at, "Pa"});
  responses.push_back({"sigma3_measured" + at, "Pa"});
  responses.push_back({"E50" + at, "Pa"});
  responses.push_back({std::string(kCompressed) + kpa(stress), "1"});
}

void add_penetration(std::vector<TableResponse>& responses, const PlateSize& plate) {
  const std::string of = std::string(kPlateMark) + plate_text(plate);
  responses.push_back({"penetration_force_0.00_0.25" + of, "N"});
  responses.push_back({"penetration_work" + of, "J"});
}

}  // namespace

std::vector<StageSpec> expand(const Design& design, const DesignPoint& point, std::uint64_t seed) {
  const StageSpec settle{.kind = StageKind::kSettle, .micro = point.micro, .numerics = point.numerics, .seed = seed,
                         .effects = acting_in(point.effects, StageKind::kSettle)};
  const auto on_bed = [&](StageKind kind, double stress, const PlateSize& plate = {}) {
    StageSpec spec = settle;
    spec.kind = kind;
    spec.confining_stress = stress;
    spec.plate = plate;
    spec.effects = acting_in(point.effects, kind);
    return spec;
  };
  std::vector<StageSpec> stages{settle, on_bed(StageKind::kFabric, 0)};
  if (design.repose) stages.push_back(on_bed(StageKind::kRepose, 0));
  for (const double stress : design.confining_stresses) stages.push_back(on_bed(StageKind::kStress, stress));
  for (const PlateSize& plate : design.plates) stages.push_back(on_bed(StageKind::kPenetration, 0, plate));
  return stages;
}

std::vector<StageSpec> expand(const Design& design) {
  std::vector<StageSpec> all;
  for (const DesignPoint& point : design.points) {
    for (const std::uint64_t seed : seeds_of(design, point)) {
      const std::vector<StageSpec> stages = expand(design, point, seed);
      all.insert(all.end(), stages.begin(), stages.end());
    }
  }
  return all;
}

std::vector<TableResponse> responses_of(const Design& design) {
  std::vector<TableResponse> responses;
  add_fabric(responses, true);
  if (design.repose) responses.push_back({"repose_angle", "rad"});
  for (const double stress : design.confining_stresses) {
    responses.push_back({"sigma1" + std::string(kSigma3Mark) + kpa(stress), "Pa"});
  }
  for (const PlateSize& plate : design.plates) {
    responses.push_back({"penetration_force_0.25_0.50" + std::string(kPlateMark) + plate_text(plate), "N"});
  }
  add_fabric(responses, false);
  if (design.repose) {
    responses.insert(responses.end(),
                     {{"repose_angle_whole", "rad"}, {"repose_angle_wedge", "rad"}, {"repose_column_stood", "1"}});
  }
  for (const double stress : design.confining_stresses) add_stress(responses, stress);
  for (const PlateSize& plate : design.plates) add_penetration(responses, plate);
  return responses;
}

ResponseSource source_of(const std::string& response) {
  for (const std::string_view mark : {kSigma3Mark, kCompressed}) {
    const std::size_t at = response.find(mark);
    if (at == std::string::npos) continue;
    double kilopascal = 0;
    const std::string_view digits = std::string_view(response).substr(at + mark.size());
    std::from_chars(digits.data(), digits.data() + digits.size(), kilopascal);
    return {StageKind::kStress, kilopascal * 1e3, {}};
  }
  if (const std::size_t at = response.find(kPlateMark); at != std::string::npos) {
    return {StageKind::kPenetration, 0, response.substr(at + kPlateMark.size())};
  }
  if (response.starts_with("repose")) return {StageKind::kRepose, 0, {}};
  return {StageKind::kFabric, 0, {}};
}

ResultTable empty_table(const Design& design, const std::string& experiment) {
  ResultTable table{.experiment = experiment,
                    .array = design.array,
                    .factors = {},
                    .fixed = design.fixed,
                    .responses = responses_of(design),
                    .rows = {}};
  for (const DesignFactor& factor : design.factors) table.factors.push_back({factor.name, factor.unit, factor.labels});
  for (const DesignPoint& point : design.points) {
    for (const std::uint64_t seed : seeds_of(design, point)) {
      table.rows.push_back({.point = point.point, .seed = seed, .level = point.level, .value = {}, .missing = {}});
    }
  }
  return table;
}

}  // namespace regolab
