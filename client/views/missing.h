/// Why cells are missing, told once for all cells that share a reason.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace regolab::client {

/// "point 7 seed 1: pending" -> "pending"; other texts as they are.
std::string reason_alone(std::string_view text);

/// Collects, for every response, the reasons of its missing cells and their places (a test, a point).
class MissingCells {
 public:
  void add(const std::string& response, const std::string& reason, int place) { cells_[response][reason].push_back(place); }
  bool empty() const { return cells_.empty(); }

  /// "  contacts, density: 25 x pending (tests 8, 9, ...)" a line; responses whose cells are missing alike share one. The
  /// places are told when `places` names them ("tests"), at most a dozen.
  std::string text(std::string_view places) const;

 private:
  std::map<std::string, std::map<std::string, std::vector<int>>> cells_;  // response -> reason -> places
};

}  // namespace regolab::client
