#include "client/views/names.h"

#include <array>
#include <utility>

#include "vocab/units.h"

namespace regolab::client {
namespace {

constexpr std::string_view kStress = "sigma1_at_sigma3_";
constexpr std::string_view kPlate = "penetration_force_0.25_0.50_plate_";
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kShort = {{
    {"contacts_per_particle", "contacts"},
    {"bulk_density", "density"},
    {"void_ratio", "void ratio"},
    {"repose_angle", "repose"},
}};

}  // namespace

bool is_primary(std::string_view response) {
  for (const auto& [id, shown] : kShort) {
    if (response == id) return true;
  }
  return response.starts_with(kStress) || response.starts_with(kPlate);
}

std::string short_name(std::string_view response) {
  for (const auto& [id, shown] : kShort) {
    if (response == id) return std::string(shown);
  }
  if (response.starts_with(kStress)) return "sigma1@" + std::string(response.substr(kStress.size()));
  if (response.starts_with(kPlate)) return "force@" + std::string(response.substr(kPlate.size()));
  return std::string(response);
}

std::string column_of(const pb::ResponseColumn& response) {
  return response.id() + unit_suffix(door_unit(response.unit_si()).name);
}

std::string column_of(const pb::FactorColumn& factor) { return factor.name() + unit_suffix(factor.unit()); }

std::string shown_unit(std::string_view unit) { return unit == "1" ? std::string() : std::string(unit); }

std::string with_unit(std::string_view name, std::string_view unit) {
  const std::string shown = shown_unit(unit);
  return shown.empty() ? std::string(name) : std::string(name) + " (" + shown + ")";
}

std::string label_of(const pb::ResultsReply& results, const pb::ResultRow& row, int factor) {
  if (factor >= row.level_size() || factor >= results.factors_size()) return {};
  const int level = row.level(factor);
  const auto& labels = results.factors(factor).levels();
  return level >= 0 && level < labels.size() ? labels[level] : std::string();
}

}  // namespace regolab::client
