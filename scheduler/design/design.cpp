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

std::vector<std::string> test_names(const Design& design) {
  std::vector<std::string> names{"settle", "contacts", "density"};
  if (design.repose) names.emplace_back("repose");
  if (!design.confining_stresses.empty()) names.emplace_back("stress");
  return names;
}

}  // namespace regolab
