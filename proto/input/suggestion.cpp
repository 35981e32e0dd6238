#include "input/suggestion.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace regolab {
namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Edits from a to b: insert, delete, replace, or swap neighbours (restricted Damerau-Levenshtein).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string_view closest(std::string_view typed, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestName = 64;
  if (typed.empty() || typed.size() > kLongestName) return {};
  std::string_view best;
  std::size_t best_edits = typed.size() <= 3 ? 2 : 3;
  for (const std::string_view name : known) {
    if (const std::size_t n = edits(typed, name); n < best_edits && n < name.size()) {
      best = name;
      best_edits = n;
    }
  }
  return best;
}

std::string join_names(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string suggestion(std::string_view typed, std::span<const std::string_view> known) {
  if (const std::string_view best = closest(typed, known); !best.empty()) return "did you mean '" + std::string(best) + "'?";
  return "known: " + join_names(known);
}

}  // namespace regolab
