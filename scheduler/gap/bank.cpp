#include "scheduler/gap/bank.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace regolab::gap {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Columns of all sources: inputs in the order first met, features in that of all_features.
void find_columns(const std::vector<BankSource>& sources, const std::vector<std::map<std::string, double>>& features, Bank& bank) {
  std::set<double> sigma3;
  std::set<std::string> plates, present;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (const auto& [input, value] : sources[i].inputs) {
      if (!bank.input(input.name)) bank.inputs.push_back(input);
    }
    for (const double stress : sigma3_of(sources[i].readings)) sigma3.insert(stress);
    for (std::string& plate : plates_of(sources[i].readings)) plates.insert(std::move(plate));
    for (const auto& [id, value] : features[i]) present.insert(id);
  }
  const std::vector<double> stresses(sigma3.begin(), sigma3.end());
  const std::vector<std::string> all_plates(plates.begin(), plates.end());
  for (const FeatureInfo& info : all_features(stresses, all_plates)) {
    if (present.contains(info.id)) bank.features.push_back(info.id);
  }
}

}  // namespace

std::optional<std::size_t> Bank::input(const std::string& name) const {
  const auto found = std::ranges::find(inputs, name, &BankInput::name);
  return found == inputs.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - inputs.begin()));
}

std::optional<std::size_t> Bank::feature(const std::string& id) const {
  const auto found = std::ranges::find(features, id);
  return found == features.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - features.begin()));
}

Bank bank_of(const std::vector<BankSource>& sources) {
  std::vector<std::map<std::string, double>> features(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (const Feature& f : features_of(sources[i].readings)) features[i][f.id] = f.value;
  }
  Bank bank;
  find_columns(sources, features, bank);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (features[i].empty()) continue;
    const BankSource& source = sources[i];
    BankRow row{.experiment = source.experiment, .point = source.point, .seed = source.seed, .profile = source.profile,
                .inputs = std::vector<double>(bank.inputs.size(), 0.0), .features = {}};
    for (const auto& [input, value] : source.inputs) row.inputs[*bank.input(input.name)] = value;
    for (const std::string& id : bank.features) {
      const auto found = features[i].find(id);
      row.features.push_back(found == features[i].end() ? kMissing : found->second);
    }
    bank.rows.push_back(std::move(row));
  }
  return bank;
}

}  // namespace regolab::gap
