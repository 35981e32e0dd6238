#include "client/views/missing.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace regolab::client {
namespace {

constexpr std::size_t kPlacesShown = 12;

}  // namespace

std::string reason_alone(std::string_view text) {
  const auto colon = text.find(": ");
  const bool placed = text.starts_with("point ") && colon != std::string_view::npos;
  return std::string(placed ? text.substr(colon + 2) : text);
}

std::string MissingCells::text(std::string_view places) const {
  std::map<std::pair<std::string, std::vector<int>>, std::vector<std::string>> alike;
  for (const auto& [response, reasons] : cells_) {
    for (const auto& [reason, where] : reasons) alike[{reason, where}].push_back(response);
  }
  std::string text;
  for (const auto& [what, responses] : alike) {
    const auto& [reason, where] = what;
    text += fmt::format("  {}: {} x {}", fmt::join(responses, ", "), where.size(), reason);
    if (!places.empty()) {
      const std::span shown(where.data(), std::min(where.size(), kPlacesShown));
      text += fmt::format(" ({} {}{})", places, fmt::join(shown, ", "), where.size() > shown.size() ? ", ..." : "");
    }
    text += "\n";
  }
  return text;
}

}  // namespace regolab::client
