#include "scheduler/gap/observation_file.h"

#include "input/field_value.h"
#include "input/map_reader.h"
#include "input/number_text.h"
#include "input/unit_convert.h"
#include "scheduler/gap/condition_blocks.h"
#include "scheduler/gap/features.h"
#include "scheduler/gap/observation_check.h"
#include "scheduler/gap/observation_end.h"

namespace regolab::gap {
namespace {

constexpr YamlLimits kLimits{.bytes = kLargestObservations, .values = 1 << 20, .remedy = "give curves of a few hundred points, and means over repeats"};

const YamlNode* child(const YamlNode& map, std::string_view key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i].text == key) return &map.items[i];
  }
  return nullptr;
}

/// An entry of `observables` or `curves`.
class Entry {
 public:
  Entry(const YamlNode& node, std::string path, int repeats, Report& report) : map_(node, std::move(path), report), node_(node), repeats_(repeats), report_(report) {}

  std::string text(std::string_view key, Place* place = nullptr, bool needed = false) {
    const YamlNode* value = needed ? map_.need(key, std::string(key) + ": " + (key == "id" ? "bulk_density" : "g/cm3")) : optional(key);
    if (place) *place = value ? value->place : node_.place;
    if (!value) return "";
    if (value->is_scalar()) return value->text;
    report_.add(value->place, map_.path_of(key) + " is " + std::string(name_of(value->kind)) + " (must be text) write one word");
    return "";
  }

  RawNumber number(const YamlNode& node) const {
    const auto read = node.is_scalar() ? leading_number(node.text) : std::nullopt;
    RawNumber out{.value = NAN, .written = node.is_scalar() ? node.text : std::string(name_of(node.kind)), .place = node.place};
    if (read && read->rest.empty()) out.value = read->value;  // a unit stands in `unit`, not here
    return out;
  }

  /// Absent and null are the same: not known.
  std::optional<RawNumber> error(std::string_view key) {
    const YamlNode* value = optional(key);
    return value ? std::optional(number(*value)) : std::nullopt;
  }

  RawList list(std::string_view key, bool needed) {
    const YamlNode* value = needed ? map_.need(key, std::string(key) + ": [0, 0.01, 0.02]") : optional(key);
    RawList out{.numbers = {}, .place = value ? value->place : node_.place};
    if (!value) return out;
    if (!value->is_list()) report_.add(value->place, map_.path_of(key) + " is " + std::string(name_of(value->kind)) + " (must be a list of numbers) write [1, 2, 3]");
    for (const YamlNode& item : value->items) out.numbers.push_back(number(item));
    return out;
  }

  int seeds() {
    const YamlNode* value = optional("seeds");
    if (!value) return repeats_ > 0 ? repeats_ : 1;
    return static_cast<int>(read_whole(*value, 1, 1000000, map_.path_of("seeds"), report_).value_or(1));
  }

  MapReader& map() { return map_; }
  /// As MapReader::get, but a null is nothing rather than a mistake.
  const YamlNode* optional(std::string_view key) {
    map_.allow(key);
    const YamlNode* value = child(node_, key);
    return value && value->kind != YamlNode::Kind::kNull ? value : nullptr;
  }

 private:
  MapReader map_;
  const YamlNode& node_;
  const int repeats_;
  Report& report_;
};

RawScalar read_scalar(const YamlNode& node, const std::string& path, int repeats, Report& report) {
  Entry entry(node, path, repeats, report);
  RawScalar raw{.id = "", .place = node.place, .id_place = {}, .value = {}, .unit = "", .unit_place = {}, .standard_error = {}, .seeds = 1, .definition = ""};
  raw.id = entry.text("id", &raw.id_place, true);
  if (const YamlNode* value = entry.map().need("value", "value: 1.63")) raw.value = entry.number(*value);
  else raw.value.place = node.place, raw.value.written = "nothing";
  raw.unit = entry.text("unit", &raw.unit_place);
  raw.standard_error = entry.error("standard_error");
  raw.seeds = entry.seeds();
  raw.definition = entry.text("definition");
  entry.optional("note");
  entry.map().finish();
  return raw;
}

/// `sigma3_kPa: 5` or `sigma3: 5 kPa`.
std::optional<RawNumber> read_sigma3(Entry& entry, Report& report) {
  const YamlNode* in_kpa = entry.optional("sigma3_kPa");
  const YamlNode* with_unit = entry.optional("sigma3");
  const YamlNode* node = in_kpa ? in_kpa : with_unit;
  if (!node) return std::nullopt;
  const auto number = node->is_scalar() ? leading_number(node->text) : std::nullopt;
  if (!number || !std::isfinite(number->value) || !(number->value > 0)) {
    report.add(node->place, "sigma3: '" + (node->is_scalar() ? excerpt(node->text) : std::string(name_of(node->kind))) + "' (must be a stress above 0) write e.g. `sigma3_kPa: 5`");
    return std::nullopt;
  }
  const auto pascals = convert_to_si(number->value, node->text, number->rest.empty() ? (in_kpa ? "kPa" : "1") : number->rest, "Pa", "confining stress");
  if (!pascals.ok()) report.add(node->place, "sigma3: " + pascals.error().text);
  return pascals.ok() ? std::optional(RawNumber{*pascals, node->text + (in_kpa ? " kPa" : ""), node->place}) : std::nullopt;
}

RawCurve read_curve(const YamlNode& node, const std::string& path, int repeats, Report& report) {
  Entry entry(node, path, repeats, report);
  RawCurve raw;
  raw.place = node.place;
  raw.id = entry.text("id", &raw.id_place, true);
  raw.test = entry.text("test");
  raw.sigma3 = read_sigma3(entry, report);
  raw.x_name = entry.text("x_name");
  raw.y_name = entry.text("y_name");
  raw.x_unit = entry.text("x_unit", &raw.x_unit_place);
  raw.y_unit = entry.text("y_unit", &raw.y_unit_place);
  raw.x = entry.list("x", true);
  raw.y = entry.list("y", true);
  if (entry.optional("y_standard_error")) raw.y_standard_error = entry.list("y_standard_error", false);
  raw.seeds = entry.seeds();
  entry.text("definition");
  entry.optional("note");
  entry.map().finish();
  return raw;
}

template <class Raw, class ReadOne>
void read_list(MapReader& top, const char* key, int repeats, std::vector<Raw>& out, Report& report, const ReadOne& read_one) {
  const YamlNode* list = top.get(key);
  if (!list) return;
  if (!list->is_list()) {
    report.add(list->place, std::string(key) + " is " + std::string(name_of(list->kind)) + " (must be a list) write `- id: ...` for each entry");
    return;
  }
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    Raw raw = read_one(list->items[i], std::string(key) + "[" + std::to_string(i + 1) + "]", repeats, report);
    if (!raw.id.empty()) out.push_back(std::move(raw));
  }
}

std::optional<ObservationSet> read(const YamlNode& root, MissingErrors missing, Report& report, Report& warnings) {
  MapReader top(root, "", report);
  const YamlNode* format = top.need("format", "format: observations/1");
  if (format && (!format->is_scalar() || format->text != "observations/1")) {
    report.add(format->place, "format: " + (format->is_scalar() ? excerpt(format->text) : std::string(name_of(format->kind))) +
                                  " (this reader knows observations/1) write `format: observations/1`, or use a program of the version that wrote it");
    return std::nullopt;  // what stands in another format is not ours to judge
  }
  ObservationSet set;
  if (const YamlNode* name = top.need("case", "case: jsc-1"); name && name->is_scalar()) set.name = excerpt(name->text);
  read_conditions(top, set, report);
  RawObservations raw;
  read_list(top, "observables", set.specimen.repeats, raw.scalars, report, read_scalar);
  read_list(top, "curves", set.specimen.repeats, raw.curves, report, read_curve);
  top.finish();
  check_observations(raw, missing, set, report, warnings);
  return set;
}

}  // namespace

Read<ObservationSet> read_observations(const std::string& file_name, const std::string& text, MissingErrors missing) {
  Report report(file_name, text.size() > kLargestObservations ? "" : text);
  Report warnings(file_name, text.size() > kLargestObservations ? "" : text);
  std::optional<ObservationSet> set;
  const auto root = parse_yaml(text, report, kLimits);
  if (root && report.empty()) set = read(*root, missing, report, warnings);
  return finished(std::move(set), report, warnings);
}

}  // namespace regolab::gap
