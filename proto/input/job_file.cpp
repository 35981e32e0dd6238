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

void check_box(const MapReader& top, const Settings& settings, Report& report) {
  const std::string problem = settings.micro.largest_diameter > 0 ? box_problem(settings) : "";
  if (problem.empty()) return;
  for (std::size_t i = 0; i < top.node().keys.size(); ++i) {
    if (top.node().keys[i].text == "box") return report.add(top.node().keys[i].place, problem);
  }
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
  read_micro(top, settings, report);
  check_box(top, settings, report);
  Tests tests = read_tests(top, report);
  top.finish();
  job.micro = settings.micro;
  job.numerics = settings.numerics;
  job.repose = tests.repose;
  job.confining_stresses = std::move(tests.confining_stresses);
  if (!report.empty()) return {std::nullopt, report.take()};
  return {std::move(job), {}};
}

}  // namespace regolab
