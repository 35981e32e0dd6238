#include "scheduler/design/design_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "input/blocks.h"
#include "input/field_value.h"
#include "scheduler/design/array_block.h"
#include "scheduler/design/array_quality.h"

namespace regolab {
namespace {

constexpr std::uint64_t kMostSeeds = 1000;
constexpr std::size_t kMostStages = 100000;

std::string read_study_name(MapReader& top, Report& report) {
  constexpr std::size_t kLongestName = 64;
  const YamlNode* node = top.get("name");
  if (node == nullptr) return "study";
  if (node->is_scalar() && !node->text.empty() && node->text.size() <= kLongestName) return excerpt(node->text);
  report.add(node->place,
             "name (must be text of 1 to " + std::to_string(kLongestName) + " bytes) write e.g. `name: friction-study`");
  return "study";
}

std::vector<std::uint64_t> first_seeds(std::uint64_t count) {
  std::vector<std::uint64_t> seeds(count);
  std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
  return seeds;
}

struct Seeds {
  std::vector<std::uint64_t> numbers = first_seeds(1);
  bool own = false;
};

/// `{first: 1000, each: 2}`: the first point has 1000 and 1001, the next 1002 and 1003.
Seeds read_own_seeds(const YamlNode& node, Report& report) {
  constexpr std::uint64_t kLargestFirst = kLargestSeed - kMostSeeds * kMostStages;
  MapReader block(node, "seeds", report);
  const YamlNode* first = block.need("first", "first: 1000");
  const YamlNode* each = block.get("each");
  block.finish();
  Seeds seeds{first_seeds(each ? read_whole(*each, 1, kMostSeeds, "seeds.each", report).value_or(1) : 1), true};
  const std::uint64_t from = first ? read_whole(*first, 0, kLargestFirst, "seeds.first", report).value_or(1) : 1;
  for (std::uint64_t& seed : seeds.numbers) seed += from - 1;
  return seeds;
}

/// `seeds: 3` is 1, 2, 3; `seeds: [1, 7]` is a list; a map gives every point seeds of its own; default one seed.
Seeds read_seeds(MapReader& top, unsigned override_count, Report& report) {
  if (override_count > kMostSeeds) {
    report.add({},
               "--seeds " + std::to_string(override_count) + " (at most " + std::to_string(kMostSeeds) + ") ask for fewer");
  }
  const YamlNode* node = top.get("seeds");
  std::vector<std::uint64_t> seeds = first_seeds(1);
  if (node != nullptr && node->is_map()) {
    Seeds own = read_own_seeds(*node, report);
    if (override_count == 0) return own;
  } else if (node != nullptr && node->is_list()) {
    seeds.clear();
    for (const YamlNode& item : node->items) {
      const auto seed = read_whole(item, 0, kLargestSeed, "seeds", report);
      if (!seed) continue;
      if (std::ranges::find(seeds, *seed) != seeds.end()) {
        report.add(item.place, "seeds: " + excerpt(item.text) + " stands twice (equal seeds give equal runs) remove one");
      }
      seeds.push_back(*seed);
    }
    if (node->items.empty() || node->items.size() > kMostSeeds) {
      report.add(node->place, "seeds (must be a number or a list of 1 to " + std::to_string(kMostSeeds) +
                                  " seeds) write e.g. `seeds: 2`");
    }
  } else if (node != nullptr) {
    seeds = first_seeds(read_whole(*node, 1, kMostSeeds, "seeds", report).value_or(1));
  }
  return {override_count > 0 && override_count <= kMostSeeds ? first_seeds(override_count) : seeds};
}

/// What the file says before points are made from it.
struct Parts {
  Settings base;  ///< profile, overrides and fixed values
  DampingUnit damping = DampingUnit::kAbsolute;
  std::vector<FixedValue> fixed;
  std::vector<std::string_view> set_elsewhere;  ///< names set by `particles`, `numerics` or `effects`
  std::vector<FactorLevels> factors;
  ArrayRows array;
  Place factors_place;
};

Place place_of_key(const YamlNode& map, std::string_view key) {
  for (const YamlKey& k : map.keys) {
    if (k.text == key) return k.place;
  }
  return map.place;
}

/// Whether the factors were to come from a table: one that could not be read says nothing about them.
bool names_table(const YamlNode& root) {
  for (std::size_t i = 0; i < root.keys.size(); ++i) {
    if (root.keys[i].text == "array") {
      return std::ranges::any_of(root.items[i].keys, [](const YamlKey& key) { return key.text == "table"; });
    }
  }
  return false;
}

void read_fixed_block(MapReader& top, Parts& parts, Report& report) {
  const YamlNode* node = top.get("fixed");
  if (node == nullptr) return;
  MapReader fixed(*node, "fixed", report);
  parts.damping = read_damping_unit(fixed, report);
  parts.base.micro.damping_unit = parts.damping;
  parts.fixed = read_fixed(fixed, parts.damping, report);
  for (const FixedValue& value : parts.fixed) {
    if (std::isfinite(value.value)) find_field(value.name)->set(parts.base, value.value);
  }
}

/// Every parameter is said exactly once: as a factor, as a fixed value, or by its block.
void check_said_once(const Parts& parts, Report& report) {
  const auto is_factor = [&](std::string_view name) {
    return std::ranges::any_of(parts.factors, [&](const FactorLevels& f) { return f.field.name == name; });
  };
  for (const Field& field : all_fields()) {
    const auto fixed = std::ranges::find(parts.fixed, field.name, &FixedValue::name);
    const std::string name(field.name);
    if (is_factor(field.name) && fixed != parts.fixed.end()) {
      report.add(fixed->place,
                 "fixed." + name + " is also a factor (a parameter either varies or does not) remove one of the two");
    }
    if (is_factor(field.name) && std::ranges::find(parts.set_elsewhere, field.name) != parts.set_elsewhere.end()) {
      report.add(parts.factors_place,
                 "factors." + name +
                     " is also set outside `factors` (a parameter either varies or does not) remove one of the two");
    }
    if (field.group == Field::Group::kMicro && !is_factor(field.name) && fixed == parts.fixed.end()) {
      report.add(parts.factors_place, "missing factor '" + name +
                                          "' (every microscopic parameter is a factor or fixed) add it to `factors`, or `" +
                                          name + ": " + std::string(field.example) + "` to `fixed`");
    }
  }
}

std::vector<DesignPoint> make_points(const Parts& parts) {
  std::vector<DesignPoint> points;
  for (const std::vector<int>& row : parts.array.rows) {
    Settings settings = parts.base;
    for (std::size_t i = 0; i < parts.factors.size(); ++i) {
      parts.factors[i].field.set(settings, parts.factors[i].values[static_cast<std::size_t>(row[i])]);
    }
    points.push_back({static_cast<int>(points.size()) + 1, row, settings.micro, settings.numerics, settings.effects});
  }
  return points;
}

/// Two equal points would be one run counted twice.
void check_distinct(const Design& design, Place place, Report& report) {
  std::map<std::vector<int>, int> seen;
  for (const DesignPoint& point : design.points) {
    const auto [first, added] = seen.emplace(point.level, point.point);
    if (added) continue;
    report.add(place, "array: points " + std::to_string(first->second) + " and " + std::to_string(point.point) +
                          " are the same (equal points give one run, which would count twice) use `auto` or `full`, or "
                          "`seeds` for repeats");
    return;
  }
}

template <class Check>
void check_points(const std::vector<DesignPoint>& points, Place place, Check check, Report& report) {
  for (const DesignPoint& point : points) {
    const std::string problem = check(Settings{point.micro, point.numerics, point.effects});
    if (problem.empty()) continue;
    report.add(place, "point " + std::to_string(point.point) + ": " + problem);
    return;  // one is enough: the others say the same
  }
}

std::map<std::string, std::string> shown_fixed(const Parts& parts) {
  std::map<std::string, std::string> shown;
  const auto show = [&](const Field& field, double value) {
    shown[std::string(field.name)] =
        door_text(field, value) + (field.si == "1" ? "" : " " + std::string(door_unit_of(field)));
  };
  const auto varies = [&](std::string_view name) {
    return std::ranges::any_of(parts.factors, [&](const FactorLevels& f) { return f.field.name == name; });
  };
  for (const FixedValue& value : parts.fixed) show(under(*find_field(value.name), parts.damping), value.value);
  if (!varies("gravity")) show(*find_field("gravity"), parts.base.micro.gravity);
  if (!varies("particle_density")) show(*find_field("particle_density"), parts.base.micro.grain_density);
  if (!varies("particles")) show(*find_field("particles"), parts.base.numerics.clusters);
  for (const EffectInfo& info : all_effects()) {
    if (const double strength = parts.base.effects[info.id]; strength != 0) show(*find_field(info.name), strength);
  }
  shown["damping_unit"] = std::string(kDampingNames[parts.damping == DampingUnit::kRatio ? 1 : 0]);
  return shown;
}

std::vector<int> level_counts(const Design& design) {
  std::vector<int> levels;
  for (const DesignFactor& factor : design.factors) levels.push_back(static_cast<int>(factor.labels.size()));
  return levels;
}

void add_notes(const Parts& parts, Design& design) {
  const ArrayQuality& quality = design.quality;
  if (const auto pair = unbalanced_pair(level_counts(design), parts.array.rows)) {
    design.notes.push_back("not orthogonal: " + design.factors[pair->first].name + " and " +
                           design.factors[pair->second].name +
                           " do not hold every pair of levels equally often, so effects are told apart by regression only");
  }
  if (quality.error_degrees_of_freedom == 0) {
    design.notes.push_back("no error degree of freedom: ranges will have no F and no leave-one-run-out");
  } else if (quality.error_degrees_of_freedom < 0) {
    design.notes.push_back("more effects than points (" + std::to_string(-quality.error_degrees_of_freedom) +
                           " too many): some effects cannot be told apart");
  }
  if (design.seeds.size() == 1) design.notes.push_back("one seed per point: no error bars from replicates");
}

Design make_design(Parts parts) {
  Design design;
  design.array = parts.array.name;
  for (std::size_t i = 0; i < parts.factors.size(); ++i) {
    const FactorLevels& factor = parts.factors[i];
    design.factors.push_back(
        {std::string(factor.field.name), std::string(door_unit_of(factor.field)), labels_of(factor), parts.array.column[i]});
  }
  design.quality = quality_of(level_counts(design), parts.array.rows);
  design.points = make_points(parts);
  design.fixed = shown_fixed(parts);
  return design;
}

void sort_by_place(std::vector<Diagnostic>& diagnostics) {
  std::ranges::stable_sort(diagnostics, [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
}

}  // namespace

Read<Design> read_design(const DesignFiles& files, const DesignOverrides& overrides) {
  Report report(files.file_name, files.text);
  const auto root = parse_yaml(files.text, report);
  if (!root) return {std::nullopt, report.take()};
  MapReader top(*root, "", report);
  Parts parts;
  std::vector<Diagnostic> elsewhere;
  const std::string name = read_study_name(top, report);
  const std::string profile = read_profile(top, overrides.profile, parts.base.numerics, report);
  Seeds seeds = read_seeds(top, overrides.seeds, report);
  parts.set_elsewhere = read_numerics(top, parts.base, report);
  read_box(top, parts.base.numerics, report);
  const auto effects = read_effects(top, parts.base, report);
  parts.set_elsewhere.insert(parts.set_elsewhere.end(), effects.begin(), effects.end());
  read_fixed_block(top, parts, report);
  parts.factors = read_factors(top, parts.damping, report);
  parts.factors_place = place_of_key(*root, "factors");
  parts.array = read_array(top, parts.damping, files.attachments, parts.factors, report, elsewhere);
  const bool table_failed = parts.factors.empty() && parts.array.rows.empty() && names_table(*root);
  if (top.is_map() && !table_failed) check_said_once(parts, report);
  if (top.is_map() && parts.factors.empty() && elsewhere.empty() && report.empty()) {
    report.add(parts.factors_place,
               "no factors (a design varies something) add `factors`, or use a job file for one material");
  }
  Tests tests = read_tests(top, report);
  top.finish();
  if (report.empty() && elsewhere.empty()) {
    Design design = make_design(parts);
    design.name = name;
    design.profile = profile;
    design.seeds = std::move(seeds.numbers);
    design.own_seeds = seeds.own;
    design.repose = tests.repose;
    design.confining_stresses = std::move(tests.confining_stresses);
    design.plates = std::move(tests.plates);
    if (!design.own_seeds) check_distinct(design, place_of_key(*root, "array"), report);
    check_points(design.points, place_of_key(*root, "box"), box_problem, report);
    const auto fits = [&](const Settings& settings) { return plate_problem(settings, design.plates); };
    check_points(design.points, place_of_key(*root, "penetration"), fits, report);
    const std::size_t stages = design.points.size() * design.seeds.size() * stages_per_run(design);
    if (stages > kMostStages) {
      report.add({}, "the study has " + std::to_string(stages) + " stages (at most " + std::to_string(kMostStages) +
                         ") use fewer points, seeds or tests");
    }
    add_notes(parts, design);
    if (report.empty()) return {std::move(design), {}};
  }
  std::vector<Diagnostic> diagnostics = report.take();
  sort_by_place(elsewhere);
  diagnostics.insert(diagnostics.end(), elsewhere.begin(), elsewhere.end());
  return {std::nullopt, std::move(diagnostics)};
}

}  // namespace regolab
