#include "scheduler/gap/condition_blocks.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "input/number_text.h"
#include "input/unit_convert.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

constexpr std::string_view kError = "_standard_error";
constexpr std::size_t kMostStresses = 64;  // in the list of a protocol

/// The unit a key ends in: "g_cm3" and "g_per_cm3" are g/cm3, "N_s_per_m" is N s/m.
std::string unit_in_key(std::string_view suffix) {
  constexpr struct {
    std::string_view written, unit;
  } kShort[] = {{"g_cm3", "g/cm3"}, {"kg_m3", "kg/m3"}, {"m_s2", "m/s2"},   {"cm_s2", "cm/s2"},
                {"N_m", "N/m"},     {"kN_m", "kN/m"},   {"N_s_m", "N s/m"}, {"Ns_m", "N s/m"}};
  for (const auto& known : kShort) {
    if (suffix == known.written) return std::string(known.unit);
  }
  std::string unit(suffix);
  if (const auto per = unit.find("_per_"); per != std::string::npos) unit.replace(per, 5, "/");
  std::ranges::replace(unit, '_', ' ');
  return unit;
}

/// A map of keys that end in their units.
class Block {
 public:
  Block(const YamlNode& node, std::string path, ObservationSet& set, Report& report)
      : node_(node), path_(std::move(path)), set_(set), report_(report), read_(node.keys.size(), false) {
    if (!node.is_map()) {
      report_.add(node.place, path_ + " is " + std::string(name_of(node.kind)) + " (must be a map) write lines of `key: value`");
    }
  }

  std::string text(std::string_view name) {
    const auto k = key_of(name, false);
    return k && node_.items[*k].is_scalar() ? excerpt(node_.items[*k].text) : "";
  }

  std::optional<double> number(std::string_view name, std::string_view si, std::string_view what) {
    const auto k = key_of(name, true);
    return k ? value_at(*k, node_.items[*k], name, si, what) : std::nullopt;
  }

  std::vector<double> list(std::string_view name, std::string_view si, std::string_view what) {
    const auto k = key_of(name, true);
    if (!k) return {};
    const YamlNode& node = node_.items[*k];
    std::vector<double> out;
    if (!node.is_list()) {
      if (const auto value = value_at(*k, node, name, si, what)) out.push_back(*value);
      return out;
    }
    if (node.items.size() > kMostStresses) {
      report_.add(node.place, path_of(*k) + " has " + std::to_string(node.items.size()) + " entries (at most " + std::to_string(kMostStresses) +
                                  ") keep those that were tested");
      return out;
    }
    for (const YamlNode& item : node.items) {
      if (const auto value = value_at(*k, item, name, si, what)) out.push_back(*value);
    }
    return out;
  }

  /// A parameter of the material, with its error where one is given.
  std::optional<Known> known(std::string_view name, const Field& field) {
    const auto k = key_of(name, true);
    if (!k) return std::nullopt;
    const std::string unit = unit_of(*k, name);
    const auto value = read_field(field, node_.items[*k], unit, path_of(*k), report_);
    Known out{.value = value.value_or(0), .standard_error = std::nullopt, .unit = std::string(field.si)};
    if (const auto e = exact(node_.keys[*k].text + std::string(kError))) {
      const auto error = quantity(*e, node_.items[*e], unit.empty() ? std::string(field.si) : unit, field.si, field.what);
      if (error && *error < 0) report_.add(node_.items[*e].place, path_of(*e) + ": " + excerpt(node_.items[*e].text) + " (must not be negative) give its size");
      out.standard_error = error;
    }
    return value ? std::optional(out) : std::nullopt;
  }

  /// What nothing has read takes no part; the author is told.
  void finish() {
    for (std::size_t k = 0; k < node_.keys.size() && node_.is_map(); ++k) {
      if (!read_[k]) set_.unused.push_back({excerpt(path_ + "." + node_.keys[k].text), "unknown key (nothing reads it) see the list of keys, or leave it"});
    }
  }

 private:
  std::string path_of(std::size_t k) const { return path_ + "." + excerpt(node_.keys[k].text); }

  std::optional<std::size_t> exact(const std::string& key) {
    if (!node_.is_map()) return std::nullopt;
    const auto found = std::ranges::find(node_.keys, key, &YamlKey::text);
    if (found == node_.keys.end()) return std::nullopt;
    const auto k = static_cast<std::size_t>(found - node_.keys.begin());
    read_[k] = true;
    return k;
  }

  /// The key `name`, or `name_UNIT` when it holds a quantity; a second one contradicts it or repeats it.
  std::optional<std::size_t> key_of(std::string_view name, bool with_unit) {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < node_.keys.size() && node_.is_map(); ++k) {
      const std::string_view key = node_.keys[k].text;
      const bool mine = key == name || (with_unit && !key.ends_with(kError) && key.starts_with(std::string(name) + "_"));
      if (!mine) continue;
      read_[k] = true;
      if (!found) set_.places[std::string(name)] = node_.items[k].place;
      if (found) report_.add(node_.keys[k].place, path_of(k) + " (already given in line " + std::to_string(node_.keys[*found].place.line) + ") keep one of them");
      else found = k;
    }
    if (found && node_.items[*found].kind == YamlNode::Kind::kNull) found.reset();  // said to be unknown
    return found;
  }

  std::string unit_of(std::size_t k, std::string_view name) const {
    const std::string_view key = node_.keys[k].text;
    return key.size() > name.size() ? unit_in_key(key.substr(name.size() + 1)) : "";
  }

  std::optional<double> value_at(std::size_t k, const YamlNode& node, std::string_view name, std::string_view si, std::string_view what) {
    const auto value = quantity(k, node, unit_of(k, name), si, what);
    if (!value || *value > 0) return value;
    report_.add(node.place, path_of(k) + ": " + excerpt(node.text) + " (must be above 0) correct it");
    return std::nullopt;
  }

  /// The number in SI; `unit` is that of the key, empty when the value carries its own.
  std::optional<double> quantity(std::size_t k, const YamlNode& node, const std::string& unit, std::string_view si, std::string_view what) {
    const auto number = node.is_scalar() ? leading_number(node.text) : std::nullopt;
    if (!number || !std::isfinite(number->value)) {
      report_.add(node.place, path_of(k) + ": " + (node.is_scalar() ? excerpt(node.text) : std::string(name_of(node.kind))) +
                                  " is not a finite number (a " + std::string(what) + " is needed) correct it");
      return std::nullopt;
    }
    const std::string_view given = number->rest.empty() ? std::string_view(unit) : number->rest;
    if (given.empty() && si != "1") {
      report_.add(node.place, path_of(k) + ": " + excerpt(node.text) + " has no unit (it is a " + std::string(what) + ") let the key end in it, e.g. `" +
                                  node_.keys[k].text.substr(0, 40) + unit_suffix(door_unit(si).name) + "`");
      return std::nullopt;
    }
    const auto value = convert_to_si(number->value, node.text + " " + std::string(given), given.empty() ? "1" : given, si, what);
    if (value.ok()) return *value;
    report_.add(node.place, path_of(k) + ": " + value.error().text);
    return std::nullopt;
  }

  const YamlNode& node_;
  const std::string path_;
  ObservationSet& set_;
  Report& report_;
  std::vector<bool> read_;  ///< by key
};

void read_source(const YamlNode& node, ObservationSet& set, Report& report) {
  const std::string said = node.is_scalar() ? node.text : std::string(name_of(node.kind));
  if (said == kLaboratory || said == kOtherCode || said == kSameCode) set.source = said;
  else report.add(node.place, "source: " + excerpt(said) + " (known: laboratory, other_code, same_code) name one, or leave the key out");
}

void read_material(const YamlNode& node, ObservationSet& set, Report& report) {
  Block block(node, "material", set, report);
  Material& m = set.material;
  m.size_law = block.text("nominal_size_law");
  m.nominal_max_size = block.number("nominal_max_size", "m", "length");
  m.nominal_min_size = block.number("nominal_min_size", "m", "length");
  if (m.nominal_max_size && m.nominal_min_size && *m.nominal_min_size > *m.nominal_max_size) {
    report.add(node.place, "material: nominal_min_size is above nominal_max_size (the sizes are swapped, or of different units) correct them");
  }
  m.grain_density = block.known("particle_density", *find_field("particle_density"));
  for (const Field& field : all_fields()) {
    if (field.group != Field::Group::kMicro) continue;
    if (auto known = block.known(field.name, field)) m.micro[std::string(field.name)] = *known;
  }
  block.finish();
}

void read_specimen(const YamlNode& node, ObservationSet& set, Report& report) {
  Block block(node, "specimen", set, report);
  set.specimen.particles = block.number("particles", "1", "number of particles");
  set.specimen.volume = block.number("volume", "m3", "volume");
  set.specimen.box_length = block.number("box_length", "m", "length");
  set.specimen.box_width = block.number("box_width", "m", "length");
  if (const auto repeats = block.number("repeats", "1", "number of specimens")) {
    if (*repeats != std::floor(*repeats) || *repeats > 1e6) report.add(node.place, "specimen.repeats (must be a whole number up to 1000000) count the specimens");
    else set.specimen.repeats = static_cast<int>(*repeats);
  }
  block.finish();
}

void read_protocol(const YamlNode& node, ObservationSet& set, Report& report) {
  Block block(node, "nominal_protocol", set, report);
  Protocol& p = set.protocol;
  p.gravity = block.number("gravity", "m/s2", "acceleration");
  p.preparation = block.text("preparation");
  p.repose = block.text("repose");
  p.stress = block.text("stress");
  p.penetration = block.text("penetration");
  p.sigma3 = block.list("sigma3", "Pa", "stress");
  p.stated_strain_rate = block.list("stated_strain_rate", "1/s", "strain rate");
  if (!p.stated_strain_rate.empty() && p.stated_strain_rate.size() != p.sigma3.size()) {
    report.add(node.place, "nominal_protocol: " + std::to_string(p.stated_strain_rate.size()) + " strain rates for " + std::to_string(p.sigma3.size()) +
                               " confining stresses (each stress has one) give as many");
  }
  const auto widths = block.list("plate_width", "m", "length"), thicknesses = block.list("plate_thickness", "m", "length");
  if (widths.size() != thicknesses.size()) report.add(node.place, "nominal_protocol: plate widths and thicknesses (must be as many) give both for each plate");
  for (std::size_t i = 0; i < std::min(widths.size(), thicknesses.size()); ++i) p.plates.push_back({widths[i], thicknesses[i]});
  block.finish();
}

}  // namespace

void read_conditions(MapReader& top, ObservationSet& set, Report& report) {
  if (const YamlNode* node = top.get("source")) read_source(*node, set, report);
  if (const YamlNode* node = top.get("material")) read_material(*node, set, report);
  if (const YamlNode* node = top.get("specimen")) read_specimen(*node, set, report);
  if (const YamlNode* node = top.get("nominal_protocol")) read_protocol(*node, set, report);
}

}  // namespace regolab::gap
