#include "input/number_text.h"
#include "scheduler/gap/observation_file.h"
#include "input/field.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

/// Double quotes, so that no text can be taken for anything else.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  }
  return out + "\"";
}

std::string in_door(double si, std::string_view unit) { return number_text(si * door_unit(unit).factor); }

class Writer {
 public:
  std::string take() { return std::move(text_); }

  void line(const std::string& key, const std::string& value, int indent = 2) { text_ += std::string(static_cast<std::size_t>(indent), ' ') + key + ": " + value + "\n"; }
  void words(const std::string& key, const std::string& value) {
    if (!value.empty()) line(key, quoted(value));
  }
  void quantity(const std::string& key, const std::optional<double>& si, std::string_view unit) {
    if (si) line(key + unit_suffix(door_unit(unit).name), in_door(*si, unit));
  }
  void known(const std::string& key, const Known& known, const Field& field) {
    const std::string full = key + (field.choices.empty() ? unit_suffix(door_unit(known.unit).name) : "");
    line(full, field.choices.empty() ? in_door(known.value, known.unit) : door_text(field, known.value));
    if (known.standard_error) line(full + "_standard_error", in_door(*known.standard_error, known.unit));
  }
  void list(const std::string& key, const std::vector<double>& si, std::string_view unit) {
    std::string all;
    for (const double value : si) all += (all.empty() ? "" : ", ") + in_door(value, unit);
    line(key, "[" + all + "]");
  }
  void block(const std::string& name) { text_ += name + ":\n"; }
  /// A block without lines would read as a key without a value.
  template <class Fill>
  void map(const std::string& name, const Fill& fill) {
    const std::size_t before = text_.size();
    block(name);
    const std::size_t filled = text_.size();
    fill();
    if (text_.size() == filled) text_.resize(before);
  }
  void entry(const std::string& id) { text_ += "- id: " + id + "\n"; }

 private:
  std::string text_;
};

void conditions(const ObservationSet& set, Writer& out) {
  out.map("material", [&] {
    out.quantity("nominal_max_size", set.material.nominal_max_size, "m");
    out.quantity("nominal_min_size", set.material.nominal_min_size, "m");
    out.words("nominal_size_law", set.material.size_law);
    if (set.material.grain_density) out.known("particle_density", *set.material.grain_density, *find_field("particle_density"));
    for (const auto& [name, known] : set.material.micro) out.known(name, known, *find_field(name));
  });
  out.map("specimen", [&] {
    if (set.specimen.particles) out.line("particles", number_text(*set.specimen.particles));
    if (set.specimen.volume) out.line("volume_m3", number_text(*set.specimen.volume));
    out.quantity("box_length", set.specimen.box_length, "m");
    out.quantity("box_width", set.specimen.box_width, "m");
    if (set.specimen.repeats > 0) out.line("repeats", std::to_string(set.specimen.repeats));
  });
  out.map("nominal_protocol", [&] {
    const Protocol& p = set.protocol;
    if (p.gravity) out.line("gravity_m_s2", number_text(*p.gravity));
    out.words("preparation", p.preparation);
    out.words("repose", p.repose);
    out.words("stress", p.stress);
    out.words("penetration", p.penetration);
    if (!p.sigma3.empty()) out.list("sigma3_kPa", p.sigma3, "Pa");
    if (!p.stated_strain_rate.empty()) out.list("stated_strain_rate_1_per_s", p.stated_strain_rate, "1/s");
    std::vector<double> widths, thicknesses;
    for (const PlateSize& plate : p.plates) widths.push_back(plate.width), thicknesses.push_back(plate.thickness);
    if (!widths.empty()) out.list("plate_width_cm", widths, "m"), out.list("plate_thickness_cm", thicknesses, "m");
  });
}

void write(const Scalar& s, Writer& out) {
  out.entry(s.id);
  out.line("value", in_door(s.value, s.unit));
  out.line("unit", quoted(std::string(door_unit(s.unit).name)));
  out.line("standard_error", s.assumed ? "null" : in_door(s.standard_error, s.unit));  // an assumption is made anew by who reads it
  out.line("seeds", std::to_string(s.seeds));
  out.words("definition", s.definition);
}

void write(const MeasuredCurve& c, Writer& out) {
  out.entry(c.id);
  out.words("test", c.test);
  if (c.sigma3 > 0) out.line("sigma3_kPa", kilopascals(c.sigma3));
  out.words("x_name", c.x_name);
  out.line("x_unit", quoted(std::string(door_unit(c.x_unit).name)));
  out.list("x", c.x, c.x_unit);
  out.words("y_name", c.y_name);
  out.line("y_unit", quoted(std::string(door_unit(c.y_unit).name)));
  out.list("y", c.y, c.y_unit);
  if (c.assumed) out.line("y_standard_error", "null");
  else out.list("y_standard_error", c.y_standard_error, c.y_unit);
  out.line("seeds", std::to_string(c.seeds));
}

}  // namespace

std::string observations_yaml(const ObservationSet& set) {
  Writer out;
  out.line("format", "observations/1", 0);
  out.line("case", quoted(set.name), 0);
  if (!set.source.empty()) out.line("source", set.source, 0);
  conditions(set, out);
  out.map("observables", [&] {
    for (const Scalar& s : set.scalars) write(s, out);
  });
  out.map("curves", [&] {
    for (const MeasuredCurve& c : set.curves) write(c, out);
  });
  return out.take();
}

}  // namespace regolab::gap
