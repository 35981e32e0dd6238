#include "scheduler/design/design.h"

namespace regolab {

std::vector<std::string> factor_columns(const Design& design) {
  std::vector<std::string> lines;
  for (const DesignFactor& factor : design.factors) {
    const std::string where = factor.column > 0 ? ", column " + std::to_string(factor.column) : "";
    lines.push_back(factor.name + ": " + std::to_string(factor.labels.size()) + " levels" + where);
  }
  return lines;
}

std::vector<std::uint64_t> seeds_of(const Design& design, const DesignPoint& point) {
  std::vector<std::uint64_t> seeds = design.seeds;
  if (!design.own_seeds) return seeds;
  for (std::uint64_t& seed : seeds) seed += static_cast<std::uint64_t>(point.point - 1) * design.seeds.size();
  return seeds;
}

std::size_t stages_per_run(const Design& design) {
  return 2 + (design.repose ? 1 : 0) + design.confining_stresses.size() + design.plates.size();
}

std::vector<std::string> test_names(const Design& design) {
  std::vector<std::string> names{"settle", "contacts", "density"};
  if (design.repose) names.emplace_back("repose");
  if (!design.confining_stresses.empty()) names.emplace_back("stress");
  if (!design.plates.empty()) names.emplace_back("penetration");
  return names;
}

}  // namespace regolab
