#include "client/materials.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "client/csv_read.h"
#include "input/field.h"
#include "input/number_text.h"
#include "input/unit_convert.h"

namespace regolab::client {
namespace {

constexpr std::size_t kLargestTable = 64 << 20;  // [bytes]

struct Heading {
  std::string name, unit;
};

/// "K_N_N_per_m" -> K_N, "N/m"; the longest field name that fits. Names that are no fields ("profile") stand as they are.
Heading heading_of(const std::string& text) {
  Heading best{text, ""};
  std::size_t longest = 0;
  for (const Field& field : all_fields()) {
    const std::string name(field.name);
    const bool fits = text == name || (text.starts_with(name) && text[name.size()] == '_');
    if (!fits || name.size() <= longest) continue;
    longest = name.size();
    best = {name, text == name ? "" : text.substr(name.size() + 1)};
  }
  for (std::size_t at; (at = best.unit.find("_per_")) != std::string::npos;) best.unit.replace(at, 5, "/");
  for (char& c : best.unit) {
    if (c == '_') c = ' ';
  }
  return best;
}

Outcome read_table(const std::string& path, const std::map<std::string, std::string>& set, pb::PredictRequest& request) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) return failed(Exit::kInvalidInput, path + " cannot be read (no such file, or no permission) correct --table");
  if (static_cast<std::size_t>(in.tellg()) > kLargestTable) return failed(Exit::kInvalidInput, path + " is larger than 64 MiB (one call answers it) split it");
  in.seekg(0);
  std::string line;
  std::vector<Heading> headings;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    const auto cells = csv_cells(line);
    if (headings.empty()) {
      for (const std::string& cell : cells) headings.push_back(heading_of(cell));
      continue;
    }
    if (cells.size() != headings.size()) {
      return failed(Exit::kInvalidInput, fmt::format("{}:{}: row has {} cells (the header has {}) complete it", path, number, cells.size(), headings.size()));
    }
    pb::Material& material = *request.add_materials();
    for (const auto& [name, value] : set) (*material.mutable_set())[name] = value;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (headings[k].name == "point" || headings[k].name == "test") continue;
      (*material.mutable_set())[headings[k].name] = cells[k] + (headings[k].unit.empty() ? "" : " " + headings[k].unit);
    }
  }
  if (request.materials().empty()) return failed(Exit::kInvalidInput, path + " holds no material (a header and one line each are needed) add some");
  return done();
}

}  // namespace

Outcome read_materials(const Arguments& arguments, pb::PredictRequest& request) {
  std::map<std::string, std::string> set;
  for (const std::string& word : arguments.set) {
    const auto at = word.find('=');
    if (at == std::string::npos || at == 0 || at + 1 == word.size()) {
      return failed(Exit::kUsage, fmt::format("--set {} (must be NAME=VALUE) write e.g. --set theta_F=40degree", word));
    }
    if (!set.try_emplace(word.substr(0, at), word.substr(at + 1)).second) {
      return failed(Exit::kUsage, fmt::format("--set {} stands twice (a parameter has one value) leave one out", word.substr(0, at)));
    }
  }
  if (!arguments.table.empty()) return read_table(arguments.table, set, request);
  auto& material = *request.add_materials();
  for (const auto& [name, value] : set) (*material.mutable_set())[name] = value;
  return done();
}

Outcome read_stresses(const Arguments& arguments, std::vector<double>& pascal) {
  for (const std::string& text : arguments.sigma3) {
    const auto number = leading_number(text);
    const auto value = number && std::isfinite(number->value) ? convert_to_si(number->value, text, number->rest.empty() ? "1" : number->rest, "Pa", "stress")
                                                              : Result<double>(invalid(text + " is no stress (a number with its unit) write e.g. 3kPa"));
    if (!value.ok()) return failed(Exit::kUsage, "--sigma3: " + value.error().text);
    if (!(*value > 0)) return failed(Exit::kUsage, "--sigma3 " + text + " (must be above 0) write e.g. 3kPa");
    pascal.push_back(*value);
  }
  return done();
}

}  // namespace regolab::client
