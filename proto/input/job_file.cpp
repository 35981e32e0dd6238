#include "input/job_file.h"

#include "input/blocks.h"
#include "input/field_value.h"

namespace regolab {
namespace {

/// All eight of the article's parameters are needed; grain density and gravity have its values.
void read_micro(MapReader& top, Settings& settings, Report& report) {
  const YamlNode* node = top.need("micro", "micro: {theta_F: 20 degree, K_N: 1e5 N/m, ...}");
  if (node == nullptr) return;
  MapReader micro(*node, "micro", report);
  const DampingUnit damping = read_damping_unit(micro, report);
  settings.micro.damping_unit = damping;
  for (const Field& shared : all_fields()) {
    const Field field = under(shared, damping);
    const bool needed = field.group == Field::Group::kMicro;
    if (!needed && field.group != Field::Group::kMaterial) continue;
    const YamlNode* value =
        needed ? micro.need(field.name, std::string(field.name) + ": " + std::string(field.example)) : micro.get(field.name);
    if (value == nullptr) continue;
    if (const auto si = read_field(field, *value, "", micro.path_of(field.name), report)) field.set(settings, *si);
  }
  micro.finish();
}

/// Where a key stands in the file; else where its block would.
Place place_of(const YamlNode& map, std::string_view key) {
  for (const YamlKey& k : map.keys) {
    if (k.text == key) return k.place;
  }
  return map.place;
}

void check_box(const MapReader& top, const Settings& settings, Report& report) {
  const std::string problem = settings.micro.largest_diameter > 0 ? box_problem(settings) : "";
  if (!problem.empty()) report.add(place_of(top.node(), "box"), problem);
}

void check_plates(const MapReader& top, const Settings& settings, const Tests& tests, Report& report) {
  if (!(settings.micro.largest_diameter > 0)) return;
  const std::string problem = plate_problem(settings, tests.plates);
  if (problem.empty()) return;
  const Place block = place_of(top.node(), "penetration");
  report.add(block == top.node().place ? place_of(top.node(), "tests") : block, problem);
}

}  // namespace

Read<Job> read_job(std::string_view text, const std::string& file_name) {
  Report report(file_name, text);
  const auto root = parse_yaml(text, report);
  if (!root) return {std::nullopt, report.take()};
  MapReader top(*root, "", report);
  Job job;
  Settings settings;
  job.profile = read_profile(top, "", settings.numerics, report);
  if (const YamlNode* seed = top.get("seed")) job.seed = read_whole(*seed, 0, kLargestSeed, "seed", report).value_or(1);
  read_numerics(top, settings, report);
  read_box(top, settings.numerics, report);
  read_effects(top, settings, report);
  read_micro(top, settings, report);
  check_box(top, settings, report);
  Tests tests = read_tests(top, report);
  check_plates(top, settings, tests, report);
  top.finish();
  job.micro = settings.micro;
  job.numerics = settings.numerics;
  job.effects = settings.effects;
  job.repose = tests.repose;
  job.confining_stresses = std::move(tests.confining_stresses);
  job.plates = std::move(tests.plates);
  if (!report.empty()) return {std::nullopt, report.take()};
  return {std::move(job), {}};
}

}  // namespace regolab
