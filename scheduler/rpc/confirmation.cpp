#include "scheduler/rpc/confirmation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "input/field.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab {
namespace {

constexpr double kMostParticles = 2000;          // more are a laboratory's: runs of that size would take days
constexpr std::uint64_t kSeedsFrom = 1'000'000, kSeedsUpTo = 1'000'000'000'000, kSeedsOfOne = 64;

/// Every digit: a run is that draw and no other.
std::string exact(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

struct Column {
  std::string name;
  const Field* field;
  std::vector<double> values;  // [n_rows] SI

  bool varies() const { return std::ranges::any_of(values, [&](double v) { return v != values.front(); }); }
  std::string cell(double si) const { return field->choices.empty() ? exact(si * door_unit(field->si).factor) : door_text(*field, si); }
  std::string heading() const { return name + (field->choices.empty() ? unit_suffix(door_unit_of(*field)) : ""); }
  std::string fixed() const {
    const std::string unit(field->choices.empty() && field->si != "1" ? " " + std::string(door_unit_of(*field)) : "");
    return name + ": " + cell(values.front()) + unit;
  }
};

const v1::WeighedModel* model_of(const v1::Diagnosis& d, const std::string& name) {
  const auto found = std::ranges::find_if(d.models(), [&](const auto& m) { return m.model() == name; });
  return found == d.models().end() ? nullptr : &*found;
}

/// What the experimenter states exactly is run so, even where the bank ends a little before it.
std::optional<double> stated_exactly(const gap::ObservationSet& set, const std::string& name) {
  if (name == "L_S" && set.material.nominal_max_size) return set.material.nominal_max_size;
  if (name == "gravity" && set.protocol.gravity) return set.protocol.gravity;
  if (name == "particle_density" && set.material.grain_density) return set.material.grain_density->value;
  const auto known = set.material.micro.find(name);
  return known == set.material.micro.end() || known->second.standard_error.value_or(0) > 0 ? std::nullopt : std::optional(known->second.value);
}

std::vector<Column> columns_of(const v1::Diagnosis& d, const gap::ObservationSet& set, const v1::WeighedModel& base, const v1::WeighedModel* repaired, int first, int draws) {
  std::vector<Column> out;
  for (int a = 0; a < d.axes_size(); ++a) {
    Column column{d.axes(a), find_field(d.axes(a)), {}};
    for (const v1::WeighedModel* model : {&base, repaired}) {
      for (int k = first; model && k < first + draws; ++k) column.values.push_back(stated_exactly(set, d.axes(a)).value_or(model->draws(k).values_si(a)));
    }
    out.push_back(std::move(column));
  }
  for (int s = 0; repaired && s < repaired->strength_size(); ++s) {
    const std::string& effect = repaired->strength(s).effect();
    Column column{effect, find_field(effect), std::vector<double>(static_cast<std::size_t>(draws), 0.0)};
    for (int k = first; k < first + draws; ++k) column.values.push_back(repaired->draws(k).strengths_si(s));
    out.push_back(std::move(column));
  }
  return out;
}

std::string table_of(const std::vector<Column>& columns) {
  std::string text, header;
  for (const Column& c : columns) header += c.varies() ? (header.empty() ? "" : ",") + c.heading() : "";
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    std::string line;
    for (const Column& c : columns) line += c.varies() ? (line.empty() ? "" : ",") + c.cell(c.values[row]) : "";
    text += "\n" + line;
  }
  return header + text + "\n";
}

/// What a case is called, as far as a name of a study can say it.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, 24)) out += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  return out;
}

std::string specimen_lines(const gap::ObservationSet& set) {
  std::string text;
  if (runs_measured_size(set)) {
    text += fmt::format("particles: {:.0f}\n", *set.specimen.particles);
    if (set.specimen.box_length && set.specimen.box_width) text += fmt::format("box: {{length: {} m, width: {} m}}\n", exact(*set.specimen.box_length), exact(*set.specimen.box_width));
  }
  return text;
}

}  // namespace

bool runs_measured_size(const gap::ObservationSet& set) { return set.specimen.particles && *set.specimen.particles <= kMostParticles; }

std::uint64_t first_seed_of(const std::string& id, const std::set<std::uint64_t>& bank_seeds) {
  std::uint64_t number = 0;
  std::from_chars(id.data(), id.data() + std::min<std::size_t>(id.size(), 12), number, 16);
  std::uint64_t seed = kSeedsFrom + number * kSeedsOfOne % kSeedsUpTo;
  for (auto met = bank_seeds.lower_bound(seed); met != bank_seeds.end() && *met < seed + kSeedsOfOne; met = bank_seeds.lower_bound(seed)) seed = *met + 1;
  return seed;
}

const v1::WeighedModel* repaired_model(const v1::Diagnosis& d) { return d.repaired().empty() ? nullptr : model_of(d, d.repaired()); }

Result<v1::SubmitRequest> confirmation_design(const v1::Diagnosis& d, const gap::ObservationSet& set, int first, int draws) {
  const v1::WeighedModel *base = model_of(d, "none"), *repaired = repaired_model(d);
  if (!base || d.held_out_pa().empty()) return Error{Code::kFailedPrecondition, "nothing to confirm (this diagnosis held nothing out) confirm the observation file"};
  if (first < 0 || draws < 1 || first + draws > base->draws_size()) return invalid("draws " + std::to_string(first) + " and on (a diagnosis keeps " + std::to_string(base->draws_size()) + ") ask for fewer");
  std::vector<Column> columns = columns_of(d, set, *base, repaired, first, draws);
  if (const auto odd = std::ranges::find(columns, nullptr, &Column::field); odd != columns.end()) {
    return Error{Code::kFailedPrecondition, "the bank's " + odd->name + " cannot be run (no parameter of a design is called so) use a bank of designs"};
  }
  const bool any = std::ranges::any_of(columns, &Column::varies);
  const auto rows = static_cast<int>(columns.front().values.size());
  const std::uint64_t seed = d.first_seed() + static_cast<std::uint64_t>(first) * (repaired ? 2 : 1);
  std::string seeds = fmt::format("{{first: {}, each: 1}}", seed);
  if (!any) {  // one material, stated exactly: its repeats are seeds of one row
    for (Column& c : columns) c.values.resize(1);
    seeds = "[";
    for (int k = 0; k < rows; ++k) seeds += fmt::format("{}{}", k ? ", " : "", seed + static_cast<std::uint64_t>(k));
    seeds += "]";
  }
  std::string fixed, stresses, table = table_of(columns);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!any && c == 0) table = columns[c].heading() + "\n" + columns[c].cell(columns[c].values.front()) + "\n";
    else if (!columns[c].varies()) fixed += (fixed.empty() ? "" : ", ") + columns[c].fixed();
  }
  const std::map<std::string, double> constants(d.constants_si().begin(), d.constants_si().end());  // in a fixed order
  for (const auto& [name, value] : constants) {
    const Field* field = find_field(name);
    if (field) fixed += (fixed.empty() ? "" : ", ") + Column{name, field, {stated_exactly(set, name).value_or(value)}}.fixed();
  }
  for (const double sigma3 : d.held_out_pa()) stresses += (stresses.empty() ? "" : ", ") + gap::kilopascals(sigma3) + " kPa";
  v1::SubmitRequest out;
  const std::string name = fmt::format("confirm-{}-{}-{}-{}", plain(d.case_name()), d.id().substr(0, 6), first + 1, first + draws);
  out.set_file_name(name + ".yaml");
  out.set_design_yaml(fmt::format("name: {}\nprofile: quick\nseeds: {}\n{}numerics: {{stress_stiffness_number: 0, isotropic_servo_steps: 200}}\narray: {{table: draws.csv}}\n"
                                  "fixed: {{{}}}\ntests: [settle, stress]\nstress: {{sigma3: [{}]}}\n",
                                  name, seeds, specimen_lines(set), fixed, stresses));
  (*out.mutable_attachments())["draws.csv"] = table;
  return out;
}

}  // namespace regolab
