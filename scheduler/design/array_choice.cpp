#include "scheduler/design/array_choice.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace regolab {
namespace {

constexpr std::size_t kLargestAutomaticFull = 256;  // rows; beyond this a full factorial must be asked for

/// Columns for the factors, 0-based: most levels first, each takes the free column with the fewest levels that suits it.
std::optional<std::vector<std::size_t>> assign(const OrthogonalArray& array, std::span<const int> levels) {
  std::vector<std::size_t> order(levels.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t i) { return levels[i]; });
  std::vector<std::size_t> column(levels.size());
  std::set<std::size_t> taken;
  for (const std::size_t factor : order) {
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < array.levels.size(); ++c) {
      if (taken.contains(c) || array.levels[c] % levels[factor] != 0) continue;
      if (!best || array.levels[c] < array.levels[*best]) best = c;
    }
    if (!best) return std::nullopt;
    taken.insert(*best);
    column[factor] = *best;
  }
  return column;
}

/// How many columns must merge levels: fewer is better among arrays of one size.
int merged_columns(const OrthogonalArray& array, std::span<const int> levels, const std::vector<std::size_t>& column) {
  int merged = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) merged += array.levels[column[i]] != levels[i] ? 1 : 0;
  return merged;
}

ChosenArray take(const OrthogonalArray& array, std::span<const int> levels, const std::vector<std::size_t>& column) {
  ChosenArray chosen{.name = array.name, .column = {}, .rows = {}};
  for (const std::size_t c : column) chosen.column.push_back(static_cast<int>(c) + 1);
  for (const auto& row : array.rows) {
    std::vector<int> point;
    for (std::size_t i = 0; i < levels.size(); ++i) point.push_back(row[column[i]] * levels[i] / array.levels[column[i]]);
    chosen.rows.push_back(std::move(point));
  }
  return chosen;
}

std::size_t full_size(std::span<const int> levels) {
  std::size_t size = 1;
  for (const int n : levels) size = std::min(size * static_cast<std::size_t>(n), kMostPoints + 1);
  return size;
}

std::string short_name(const std::string& name) { return name.substr(0, name.find(' ')); }

bool is_named(const OrthogonalArray& array, std::string_view wanted) {
  std::string compact;  // "L16(4^5)" and "L16 (4^5)" are one
  for (const char c : array.name) compact += c == ' ' && compact.find('(') == std::string::npos ? "" : std::string(1, c);
  return wanted == array.name || wanted == compact || wanted == short_name(array.name);
}

/// The array of fewest rows, then fewest merged columns, among those that `wanted` names ("" = any).
std::optional<ChosenArray> best_fit(std::string_view wanted, std::span<const int> levels) {
  const OrthogonalArray* best = nullptr;
  std::vector<std::size_t> best_columns;
  for (const OrthogonalArray& array : built_in_arrays()) {
    if (!wanted.empty() && !is_named(array, wanted)) continue;
    if (best != nullptr && array.rows.size() > best->rows.size()) continue;
    const auto columns = assign(array, levels);
    if (!columns) continue;
    if (best == nullptr || merged_columns(array, levels, *columns) < merged_columns(*best, levels, best_columns)) {
      best = &array;
      best_columns = *columns;
    }
  }
  if (best == nullptr) return std::nullopt;
  return take(*best, levels, best_columns);
}

ChosenArray take_full(std::span<const int> levels) {
  OrthogonalArray full = full_factorial(levels);
  return {.name = std::move(full.name), .column = std::vector<int>(levels.size(), 0), .rows = std::move(full.rows)};
}

/// "what would fit": per distinct level count the arrays that carry as many such factors, and the full factorial.
std::string what_fits(std::span<const int> levels) {
  std::string text;
  for (const int n : std::set<int>(levels.begin(), levels.end())) {
    const std::vector<int> alike(static_cast<std::size_t>(std::ranges::count(levels, n)), n);
    const auto fit = best_fit("", alike);
    text += (text.empty() ? "" : "; ") + std::to_string(alike.size()) + " factor" + (alike.size() == 1 ? "" : "s") + " of " +
            std::to_string(n) + " levels fit " + (fit ? fit->name : "no built-in array");
  }
  const std::size_t full = full_size(levels);
  return text + (full <= kMostPoints ? "; `full` takes " + std::to_string(full) + " points" : "");
}

Error no_fit(const std::string& what, std::span<const int> levels) {
  const auto best = best_fit("", levels);
  const std::string remedy = best ? "use " + best->name : "change level counts, or give a table; " + what_fits(levels);
  return invalid(what + " (" + level_formula(levels) + " is needed) " + remedy);
}

}  // namespace

Result<ChosenArray> choose_array(std::string_view wanted, std::span<const int> levels) {
  const std::size_t full = full_size(levels);
  if (wanted == "full") {
    if (full <= kMostPoints) return take_full(levels);
    return invalid("the full factorial has more than " + std::to_string(kMostPoints) + " points (" + level_formula(levels) +
                   ") use `auto` or an orthogonal array");
  }
  if (wanted == "auto") {
    auto fit = best_fit("", levels);
    if (full <= (fit ? fit->rows.size() : kLargestAutomaticFull)) return take_full(levels);
    if (fit) return *std::move(fit);
    return no_fit("these level counts fit no built-in array", levels);
  }
  const auto arrays = built_in_arrays();
  if (std::ranges::none_of(arrays, [&](const auto& array) { return is_named(array, wanted); })) {
    return invalid("unknown array '" + std::string(wanted.substr(0, 40)) + "' (built in: " + list_of_arrays() +
                   ") choose one, `auto` or `full`");
  }
  if (auto fit = best_fit(wanted, levels)) return *std::move(fit);
  std::string forms;
  for (const auto& array : arrays) {
    if (is_named(array, wanted)) forms += (forms.empty() ? "" : " or ") + array.name.substr(array.name.find('('));
  }
  return no_fit("the factors do not fit " + std::string(wanted.substr(0, wanted.find('('))) + " " + forms, levels);
}

std::string list_of_arrays() {
  std::string text;
  for (const OrthogonalArray& array : built_in_arrays()) text += (text.empty() ? "" : ", ") + array.name;
  return text;
}

}  // namespace regolab
