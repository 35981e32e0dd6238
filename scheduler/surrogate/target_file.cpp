#include "scheduler/surrogate/target_file.h"

#include <algorithm>
#include <cmath>

#include "input/field_value.h"
#include "input/map_reader.h"
#include "input/number_text.h"
#include "input/suggestion.h"
#include "input/unit_convert.h"
#include "scheduler/surrogate/curves.h"
#include "scheduler/surrogate/material.h"
#include "vocab/units.h"

namespace regolab::surrogate {
namespace {

class TargetReader {
 public:
  TargetReader(const Model& model, Report& report) : model_(model), report_(report) {}

  Question read(const YamlNode& root) {
    MapReader top(root, "", report_);
    Question question;
    if (const YamlNode* name = top.get("name"); name && name->is_scalar()) question.name = excerpt(name->text);
    if (const YamlNode* targets = top.need("targets", "targets: {bulk_density: {value: 1.63 g/cm3, tolerance: 1 %}}")) {
      read_targets(*targets, question.targets);
      check_contradictions(*targets, question.targets);
    }
    open_box(question.spans);
    if (const YamlNode* fixed = top.get("fixed")) narrow(*fixed, "fixed", question.spans);
    if (const YamlNode* free = top.get("free")) narrow(*free, "free", question.spans);
    top.finish();
    return question;
  }

 private:
  /// A number with unit; "1 %" is a share of `whole` where one is given.
  std::optional<double> quantity(const YamlNode& node, const std::string& si, const std::string& path, double whole = 0) {
    const auto number = node.is_scalar() ? leading_number(node.text) : std::nullopt;
    if (!number || !std::isfinite(number->value)) {
      report_.add(node.place, path + " (must be a number with its unit) write e.g. `" + path + ": 1.63 g/cm3`");
      return std::nullopt;
    }
    if (number->rest == "%" && whole != 0) return std::abs(whole) * number->value / 100;
    if (number->rest.empty() && si != "1") {
      report_.add(node.place, path + ": " + excerpt(node.text) + " has no unit (it is measured in " + std::string(door_unit(si).name) +
                                  ") write e.g. `" + excerpt(node.text) + " " + std::string(door_unit(si).name) + "`");
      return std::nullopt;
    }
    const auto value = convert_to_si(number->value, node.text, number->rest.empty() ? "1" : number->rest, si, path);
    if (!value.ok()) report_.add(node.place, path + ": " + value.error().text);
    return value.ok() ? std::optional(*value) : std::nullopt;
  }

  void read_value_and_tolerance(MapReader& map, Target& target, const std::string& path, bool& good) {
    const std::string unit(door_unit(target.unit).name);
    const YamlNode* value = map.need("value", "value: 1.63 g/cm3");
    const YamlNode* tolerance = map.need("tolerance", "tolerance: 1 %");
    const auto v = value ? quantity(*value, target.unit, path + ".value") : std::nullopt;
    const auto t = tolerance && v ? quantity(*tolerance, target.unit, path + ".tolerance", *v) : std::nullopt;
    if (t && !(*t > 0)) report_.add(tolerance->place, path + ".tolerance " + excerpt(tolerance->text) + " (must be above 0) write e.g. `tolerance: 1 %`");
    good = v && t && *t > 0;
    if (good) target.value = *v, target.tolerance = *t;
  }

  /// sigma1 or friction_angle at a confining stress. A friction angle is the secant one: sigma1 = sigma3 (1 + sin) / (1 - sin).
  void read_stress(const YamlNode& node, const std::string& path, bool as_angle, std::vector<Target>& targets) {
    MapReader map(node, path, report_);
    const YamlNode* at = map.need("sigma3", "sigma3: 10 kPa");
    Target target{.response = "", .unit = as_angle ? "rad" : "Pa"};
    bool good = false;
    read_value_and_tolerance(map, target, path, good);
    const auto sigma3 = at ? quantity(*at, "Pa", path + ".sigma3") : std::nullopt;
    map.finish();
    if (!good || !sigma3) return;
    if (!model_.sigma1_at(model_.data.rows.front().x, *sigma3)) {
      report_.add(at->place, path + ".sigma3 " + excerpt(at->text) + " (the model was trained on other confining stresses) see `regolab models`");
      return;
    }
    if (as_angle) {
      if (!(target.value > 0 && target.value + target.tolerance < 1.5)) {
        report_.add(node.place, path + " (a friction angle lies between 0 and 85 deg) check value and unit");
        return;
      }
      const auto stress = [&](double angle) { return *sigma3 * (1 + std::sin(angle)) / (1 - std::sin(angle)); };
      const double low = stress(std::max(0.0, target.value - target.tolerance)), high = stress(target.value + target.tolerance);
      target.value = 0.5 * (low + high), target.tolerance = 0.5 * (high - low), target.unit = "Pa";
    }
    target.sigma3 = *sigma3;
    target.response = "sigma1_at_sigma3_" + kilopascals(*sigma3);
    targets.push_back(target);
  }

  void read_targets(const YamlNode& node, std::vector<Target>& targets) {
    if (!node.is_map() || node.items.empty()) {
      report_.add(node.place, "targets (must be a map of properties) write e.g. `targets: {bulk_density: {value: 1.63 g/cm3, tolerance: 1 %}}`");
      return;
    }
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
      const std::string& name = node.keys[i].text;
      const std::string path = "targets." + name;
      if (name == "sigma1" || name == "friction_angle") {
        const YamlNode& list = node.items[i];
        for (std::size_t k = 0; k < (list.is_list() ? list.items.size() : 1); ++k) {
          read_stress(list.is_list() ? list.items[k] : list, path, name == "friction_angle", targets);
        }
        continue;
      }
      const ResponseModel* response = model_.find(name);
      if (!response) {
        std::vector<std::string_view> known{"sigma1", "friction_angle"};
        for (const ResponseModel& r : model_.responses) known.push_back(r.id);
        report_.add(node.keys[i].place, "unknown property '" + excerpt(name) + "' (the model does not predict it) " + suggestion(name, known));
        continue;
      }
      MapReader map(node.items[i], path, report_);
      Target target{.response = name, .unit = response->unit};
      bool good = false;
      read_value_and_tolerance(map, target, path, good);
      map.finish();
      if (good) targets.push_back(target);
    }
  }

  /// Void ratio and density say the same thing twice where the grain density is known; any property may stand twice.
  void check_contradictions(const YamlNode& node, const std::vector<Target>& targets) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      for (std::size_t k = i + 1; k < targets.size(); ++k) {
        const Target &a = targets[i], &b = targets[k];
        if (a.response == b.response && std::abs(a.value - b.value) > a.tolerance + b.tolerance) {
          report_.add(node.place, "targets contradict each other (" + a.response + " cannot have two values) keep one");
        }
      }
    }
    const auto find = [&](std::string_view id) { return std::ranges::find(targets, id, &Target::response); };
    const auto rho = find("bulk_density"), e = find("void_ratio");
    const auto grain = model_.data.fixed.find("particle_density");
    if (rho == targets.end() || e == targets.end() || grain == model_.data.fixed.end()) return;
    const auto density = input_value("particle_density", grain->second);
    if (!density.ok()) return;
    const double least = *density / (rho->value + rho->tolerance) - 1, most = *density / (rho->value - rho->tolerance) - 1;
    if (e->value + e->tolerance < least || e->value - e->tolerance > most) {
      report_.add(node.place, "targets contradict each other (a bulk density of that size leaves a void ratio of " + number_text(std::round(1000 * least) / 1000) +
                                  " to " + number_text(std::round(1000 * most) / 1000) + ") drop one of the two");
    }
  }

  void open_box(std::vector<Question::Span>& spans) {
    for (std::size_t c = 0; c < model_.data.columns.size(); ++c) {
      const InputColumn& column = model_.data.columns[c];
      Question::Span span{column.low, column.high, {}};
      for (std::size_t k = 0; column.is_choice() && k < column.labels.size(); ++k) {
        const auto value = static_cast<double>(k);
        if (std::ranges::any_of(model_.data.rows, [&](const DataRow& row) { return row.x[c] == value; })) span.choices.push_back(value);
      }
      if (column.is_choice() && is_of_the_run(column.name)) span.choices.resize(1);
      if (!column.is_choice() && is_of_the_run(column.name)) span.high = span.low;  // the cheapest run, unless the file says otherwise
      spans.push_back(std::move(span));
    }
  }

  std::optional<double> input(const InputColumn& column, const YamlNode& node, const std::string& path) {
    if (!node.is_scalar()) {
      report_.add(node.place, path + " (must be a value with its unit) write e.g. `" + column.name + ": " + input_text(column, column.low) + "`");
      return std::nullopt;
    }
    const auto value = input_value(column.name, node.text);
    if (!value.ok()) report_.add(node.place, path + ": " + value.error().text);
    return value.ok() ? std::optional(*value) : std::nullopt;
  }

  bool inside(const InputColumn& column, double value) const {
    const double slack = 1e-6 * (column.high - column.low);
    return column.is_choice() || (value >= column.low - slack && value <= column.high + slack);
  }

  void narrow(const YamlNode& node, const std::string& block, std::vector<Question::Span>& spans) {
    if (!node.is_map()) {
      report_.add(node.place, block + " (must be a map of parameters) write e.g. `" + block + ": {L_S: 1 cm}`");
      return;
    }
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
      const std::string path = block + "." + node.keys[i].text;
      const auto column = std::ranges::find(model_.data.columns, node.keys[i].text, &InputColumn::name);
      if (column == model_.data.columns.end()) {
        std::vector<std::string_view> known;
        for (const InputColumn& c : model_.data.columns) known.push_back(c.name);
        const auto kept = model_.data.fixed.find(node.keys[i].text);
        report_.add(node.keys[i].place, kept != model_.data.fixed.end()
                                            ? path + " (all data have " + kept->second + ", so the model cannot tell what it does) leave it out"
                                            : "unknown parameter '" + excerpt(node.keys[i].text) + "' (the model does not have it) " + suggestion(node.keys[i].text, known));
        continue;
      }
      set_span(*column, node.items[i], block == "free", path, spans[static_cast<std::size_t>(column - model_.data.columns.begin())]);
    }
  }

  void set_span(const InputColumn& column, const YamlNode& node, bool free, const std::string& path, Question::Span& span) {
    std::vector<double> values;
    const bool list = free && node.is_list();
    if (free && !list) {
      report_.add(node.place, path + " (must be a list) write e.g. `" + column.name + ": [" + input_text(column, column.is_choice() ? 0 : column.low) + ", " +
                                  input_text(column, column.is_choice() ? 1 : column.high) + "]`");
      return;
    }
    for (std::size_t k = 0; k < (list ? node.items.size() : 1); ++k) {
      const YamlNode& item = list ? node.items[k] : node;
      const auto value = input(column, item, path);
      if (!value) return;
      if (!inside(column, *value)) {
        report_.add(item.place, path + ": " + excerpt(item.text) + " is outside the model's data (" + input_text(column, column.low) + " to " +
                                    input_text(column, column.high) + ") stay inside, or train on more");
        return;
      }
      values.push_back(*value);
    }
    if (column.is_choice()) {
      if (!values.empty()) span.choices = values;
      return;
    }
    if (list && (values.size() != 2 || values[0] >= values[1])) {
      report_.add(node.place, path + " (must be [low, high]) write the smaller value first");
      return;
    }
    span.low = values.front(), span.high = values.back();
  }

  const Model& model_;
  Report& report_;
};

}  // namespace

Read<Question> read_target(const std::string& file_name, const std::string& text, const Model& model) {
  Report report(file_name, text);
  std::optional<Question> question;
  if (const auto root = parse_yaml(text, report)) question = TargetReader(model, report).read(*root);
  Read<Question> out{.value = std::nullopt, .diagnostics = report.take()};
  if (out.diagnostics.empty()) out.value = std::move(question);
  return out;
}

}  // namespace regolab::surrogate
