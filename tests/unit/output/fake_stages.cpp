#include "unit/output/fake_stages.h"

#include <charconv>

#include "digest/sha256.h"
#include "vocab/profile.h"
#include "vocab/units.h"
#include "worker/output/finished_stage.h"
#include "worker/output/number_text.h"

namespace regolab::test {
namespace {

constexpr std::string_view kBedMark = "fake bed ";

std::string state_text(const StageSpec& spec, std::uint64_t step, std::uint64_t sum) {
  return stage_key(spec) + " " + std::to_string(step) + " " + std::to_string(sum);
}

/// False when `text` is not a state of this stage.
bool read_state(const StageSpec& spec, const std::string& text, std::uint64_t& step, std::uint64_t& sum) {
  const std::string key = stage_key(spec) + " ";
  if (!text.starts_with(key)) return false;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data() + key.size(), end, step);
  return first.ec == std::errc{} && first.ptr < end && std::from_chars(first.ptr + 1, end, sum).ec == std::errc{};
}

StageResult result_of(const StageSpec& spec, std::uint64_t sum) {
  const double number = static_cast<double>(sum % 1000003) / 3.0;
  StageResult result;
  result.numerics = {{"time_step", number * 1e-12, "s", std::nullopt, "the step taken"}};
  switch (spec.kind) {
    case StageKind::kSettle:
      result.curves = {{"kinetic_energy", "settle", "time", "s", "kinetic_energy", "J", {0.0, 0.1}, {number, 1e-20}}};
      break;
    case StageKind::kFabric:
      result.measurements = {{"contacts_per_particle", number, "1", std::nullopt, "each pair once"},
                             {"bulk_density", 1416.0, "kg/m3", std::nullopt, "rho_P V_P/(L W H)"}};
      break;
    case StageKind::kRepose:
      result.measurements = {{"repose_angle", 45.5 * kDegree, "rad", 1.5 * kDegree, "line through the slope"}};
      result.curves = {
          {"repose_profile", "repose", "distance_from_left_wall", "m", "surface_height", "m", {0.01, 0.02}, {0.05, 0.04}}};
      break;
    case StageKind::kStress: {
      const std::string id = "sigma1_at_sigma3_" + shortest_text(spec.confining_stress / 1000) + "kPa";
      result.measurements = {{id, 3.5 * spec.confining_stress, "Pa", std::nullopt, "mean axial stress"}};
      result.curves = {{id, "stress", "axial_strain", "1", "sigma1", "Pa", {0.0, 0.1}, {spec.confining_stress, number}}};
      break;
    }
    case StageKind::kPenetration: {
      const std::string plate = plate_text(spec.plate);
      result.measurements = {{"penetration_force_0.25_0.50_plate_" + plate, 3.5, "N", 0.5, "mean force"}};
      result.curves = {{"penetration_force_plate_" + plate, "penetration", "depth", "m", "force", "N", {0.00025, 0.00075}, {1.5, number}}};
      break;
    }
  }
  return result;
}

}  // namespace

Result<StageOutput> FakeStages::run(const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                                    const StageHooks& hooks) {
  started.push_back(spec.kind);
  if (needs_bed(spec.kind) && !bed.starts_with(kBedMark)) return Error{Code::kDataLoss, "bed is damaged"};
  std::uint64_t step = 0;
  std::uint64_t sum = spec.seed + std::hash<std::string>{}(bed) + static_cast<std::uint64_t>(spec.confining_stress);
  if (!checkpoint.empty() && !read_state(spec, checkpoint, step, sum))
    return Error{Code::kDataLoss, "checkpoint is damaged"};
  StageOutput output;
  for (; step < steps; ++step) {
    if (hooks.stop.stop_requested()) {
      if (hooks.on_checkpoint) hooks.on_checkpoint(state_text(spec, step, sum));
      output.result.end = StageEnd::kCancelled;
      return output;
    }
    if (step % steps_between_checkpoints == 0 && hooks.on_checkpoint) hooks.on_checkpoint(state_text(spec, step, sum));
    if (hooks.on_progress) hooks.on_progress({"sum", static_cast<double>(step) / static_cast<double>(steps), step, 1e6});
    if (at_step) at_step(spec, step);
    sum = sum * 6364136223846793005u + step;
    ++steps_done;
  }
  output.steps = steps;
  output.result = result_of(spec, sum);
  if (end_of) output.result.end = end_of(spec);
  if (output.result.end != StageEnd::kCompleted)
    output.result.reason = "grains overlap too much (0.3 of a radius) take a smaller step_fraction";
  const std::string state = std::string(kBedMark) + std::to_string(sum);
  (needs_bed(spec.kind) ? output.final_state : output.bed) = state;
  return output;
}

BedView small_bed() {
  return {.length = 0.03,
          .width = 0.02,
          .height = 0.025,
          .clusters = 2,
          .spheres = {{0, 0.01, 0.01, 0.005, 0.005, 0.0, 0.0, 0.0},
                      {1, 0.01, 0.01, 0.0149, 0.005, 0.1, -0.2, 1.0 / 3.0},
                      {1, 0.02, 0.01, 0.0149, 0.005, 0.1, -0.2, 0.0}},
          .contacts = {{0, 1, 0.01, 0.01, 0.00995, 2.5}, {0, -1 - 4, 0.01, 0.01, 0.0, 4.0}}};
}

Result<BedView> view_fake_bed(const std::string& bed) {
  if (!bed.starts_with(kBedMark)) return Error{Code::kDataLoss, "bed is damaged"};
  return small_bed();
}

Job small_job() {
  Job job;
  job.numerics = *profile("quick");
  job.micro = {.friction_angle = 20 * kDegree,
               .normal_stiffness = 1e5,
               .normal_damping = 0.25,
               .tangential_stiffness = 7.5e4,
               .tangential_damping = 1,
               .largest_diameter = 0.01};
  job.repose = true;
  job.confining_stresses = {1250, 2500};
  return job;
}

}  // namespace regolab::test
