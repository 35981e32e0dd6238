#include "support/fake_stage.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "digest/sha256.h"
#include "vocab/canonical.h"

namespace regolab::test {
namespace {

constexpr int kSteps = 200;

/// One step of a chain: skip one, or do one twice, and every later number differs.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}
double unit(std::uint64_t x) { return static_cast<double>(x >> 11) * 0x1p-53; }

std::uint64_t first_state(const StageSpec& spec) { return std::stoull(stage_key(spec).substr(0, 15), nullptr, 16); }

StageResult measure(const StageSpec& spec, std::uint64_t state, std::vector<double> path) {
  StageResult result;
  const double noise = unit(state);
  const auto add = [&](const std::string& id, double value, const char* unit_si) {
    result.measurements.push_back({id, value, unit_si, {}, "made up"});
  };
  if (spec.kind == StageKind::kFabric) {
    add("contacts_per_particle", 4 + noise, "1");
    add("bulk_density", 1500 + 100 * noise, "kg/m3");
    add("void_ratio", 0.8 + 0.1 * noise, "1");
  }
  if (spec.kind == StageKind::kRepose) add("repose_angle", spec.micro.friction_angle + 0.01 * noise, "rad");
  if (spec.kind == StageKind::kStress) {
    std::ostringstream id;
    id << "sigma1_at_sigma3_" << std::round(spec.confining_stress) / 1000 << "kPa";
    add(id.str(), spec.confining_stress * (2 + noise), "Pa");
    std::vector<double> strain(path.size());
    for (std::size_t i = 0; i < strain.size(); ++i) strain[i] = 0.001 * static_cast<double>(i);
    result.curves.push_back({id.str(), "stress", "axial_strain", "1", "sigma1", "Pa", std::move(strain), std::move(path)});
  }
  result.numerics.push_back({"steps", kSteps, "1", {}, "made up"});
  return result;
}

}  // namespace

Result<StageOutput> FakeStage::operator()(const StageSpec& spec, const std::string& bed, const std::string& checkpoint,
                                          const StageHooks& hooks) const {
  using Clock = std::chrono::steady_clock;
  const std::string name = canonical_text(spec);
  if (needs_bed(spec.kind) && bed != "bed of\n" + canonical_text(parent_of(spec))) {
    return Error{Code::kDataLoss, "bed refused (of another stage)"};
  }
  if (broken_seed != 0 && spec.seed == broken_seed && spec.kind == StageKind::kFabric)
    return invalid("made to fail (a test)");
  int step = 0;
  std::uint64_t state = first_state(spec);
  std::vector<double> path;
  if (!checkpoint.empty()) {
    std::istringstream in{checkpoint};
    std::string key;
    in >> key >> step >> state;
    if (key != stage_key(spec)) return Error{Code::kDataLoss, "checkpoint refused (of another stage)"};
    std::uint64_t again = first_state(spec);
    for (int i = 0; i < step; ++i) path.push_back(unit(again = mix(again)));
    if (again != state) return Error{Code::kDataLoss, "checkpoint refused (damaged)"};
  }
  const int steps = spec.kind == StageKind::kFabric ? 1 : kSteps;
  const auto pause = std::chrono::duration<double>(spec.kind == StageKind::kFabric ? 0 : duration_s / kSteps);
  const auto begun = Clock::now();
  auto saved = begun;
  const auto save = [&] {
    saved = Clock::now();
    std::ostringstream out;
    out << stage_key(spec) << ' ' << step << ' ' << state;
    if (hooks.on_checkpoint) hooks.on_checkpoint(out.str());
  };
  StageOutput output;
  while (step < steps) {
    if (hooks.stop.stop_requested()) {
      save();
      output.result.end = StageEnd::kCancelled;
      return output;
    }
    if (poison_seed != 0 && spec.seed == poison_seed && spec.kind == StageKind::kRepose && step == steps / 2) std::abort();
    state = mix(state);
    path.push_back(unit(state));
    ++step;
    if (duration_s > 0) std::this_thread::sleep_for(pause);
    if (hooks.on_progress) {
      hooks.on_progress({"pretending", static_cast<double>(step) / steps, static_cast<std::uint64_t>(step), 1e6});
    }
    if (std::chrono::duration<double>(Clock::now() - saved).count() > hooks.checkpoint_every_s) save();
  }
  output.result = measure(spec, state, std::move(path));
  if (restless_seed != 0 && spec.seed == restless_seed && spec.kind == StageKind::kSettle) {
    output.result.end = StageEnd::kNotSettled;
    output.result.reason = "time limit before rest (a test) settle longer";
  }
  if (spec.kind == StageKind::kSettle) output.bed = "bed of\n" + name;
  output.steps = static_cast<std::uint64_t>(steps);
  output.wall_s = std::chrono::duration<double>(Clock::now() - begun).count();
  return output;
}

}  // namespace regolab::test
