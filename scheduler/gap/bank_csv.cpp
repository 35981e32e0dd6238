#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "input/report.h"
#include "input/yaml_tree.h"
#include "scheduler/gap/bank.h"
#include "scheduler/gap/csv_lines.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

constexpr int kDigits = 7;
constexpr std::string_view kFixed[] = {"experiment", "point", "seed", "profile"};
/// Units that inputs may have; the longest ending that fits names the unit of a column.
constexpr std::string_view kUnits[] = {"1/Pa", "N s/m", "kg/m3", "m/s2", "J/m2", "N/m3", "N/m", "m/s", "1/s", "rad", "Pa", "kg", "N", "J", "m", "s"};

std::string seven_digits(double value) {
  if (std::isnan(value)) return "";
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, kDigits);
  return {text, end.ptr};
}

/// SI unit of a feature's value, which for logarithms and shares is none.
std::string unit_of(const FeatureInfo& info) { return info.kind == Kind::kPlain && info.scale == 1 ? info.unit : "1"; }

std::string heading(const std::string& name, const std::string& unit) { return name + unit_suffix(unit); }

BankInput input_of(std::string_view column) {
  for (const std::string_view unit : kUnits) {
    const std::string ending = unit_suffix(unit);
    if (column.ends_with(ending) && column.size() > ending.size()) return {std::string(column.substr(0, column.size() - ending.size())), std::string(unit)};
  }
  return {std::string(column), "1"};
}

/// The feature whose column this is; empty for an input.
std::string feature_of(std::string_view column) {
  for (const std::string_view unit : {"1", "rad", "kg/m3"}) {
    const std::string ending = unit_suffix(unit);
    if (!column.ends_with(ending)) continue;
    const std::string id(column.substr(0, column.size() - ending.size()));
    const auto info = feature_info(id);
    if (info && unit_of(*info) == unit) return id;
  }
  return "";
}

class BankReader {
 public:
  explicit BankReader(Report& report) : report_(report) {}

  Bank read(std::string_view text) {
    Bank bank;
    int line = 0;
    for_each_line(text, [&](std::string_view content) {
      ++line;
      if (columns_ == 0) return header(csv_cells(content), line, bank);
      if (!content.empty()) row(csv_cells(content), line, bank);
    });
    if (columns_ == 0) report_.add({}, "empty file (a bank has a line of column names) write one with `regolab gap bank EXPERIMENT -o bank.csv`");
    else if (bank.rows.empty() && report_.empty()) report_.add({}, "no rows (a bank has one for each point and seed) write one with `regolab gap bank EXPERIMENT -o bank.csv`");
    return bank;
  }

 private:
  void header(const std::vector<CsvCell>& cells, int line, Bank& bank) {
    columns_ = cells.size();
    for (std::size_t c = 0; c < std::size(kFixed); ++c) {
      if (c < cells.size() && cells[c].text == kFixed[c]) continue;
      report_.add({line, c < cells.size() ? cells[c].column : 1}, "column " + std::to_string(c + 1) + " (must be `" + std::string(kFixed[c]) +
                                                                      "`) write the bank with `regolab gap bank EXPERIMENT -o bank.csv`");
      bad_header_ = true;
      return;
    }
    for (std::size_t c = std::size(kFixed); c < cells.size(); ++c) {
      const std::string id = feature_of(cells[c].text);
      const BankInput input = input_of(cells[c].text);
      if (cells[c].text.empty() || (id.empty() ? bank.input(input.name).has_value() : bank.feature(id).has_value())) {
        report_.add({line, cells[c].column}, "column '" + excerpt(cells[c].text) + "' (empty, or there already) name each column once");
      }
      is_feature_.push_back(!id.empty());
      if (id.empty()) bank.inputs.push_back(input);
      else bank.features.push_back(id);
    }
  }

  void row(const std::vector<CsvCell>& cells, int line, Bank& bank) {
    if (bad_header_) return;
    if (cells.size() != columns_) {
      report_.add({line, 1}, std::to_string(cells.size()) + " cells (the header has " + std::to_string(columns_) + ") the file may be cut off");
      return;
    }
    BankRow row{.experiment = cells[0].text, .point = static_cast<int>(whole(cells[1], line, 1'000'000'000)), .seed = whole(cells[2], line, ~std::uint64_t{0}),
                .profile = cells[3].text, .inputs = {}, .features = {}};
    for (std::size_t c = std::size(kFixed); c < cells.size(); ++c) {
      const bool feature = is_feature_[c - std::size(kFixed)];
      (feature ? row.features : row.inputs).push_back(number(cells[c], line, feature));
    }
    const auto [first, fresh] = seen_.try_emplace({row.experiment, row.point, row.seed}, line);
    if (!fresh) report_.add({line, 1}, "this point and seed stand in line " + std::to_string(first->second) + " already (they would count twice) remove one");
    bank.rows.push_back(std::move(row));
  }

  std::uint64_t whole(const CsvCell& cell, int line, std::uint64_t most) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), value);
    if (error == std::errc{} && end == cell.text.data() + cell.text.size() && value <= most) return value;
    report_.add({line, cell.column}, "'" + excerpt(cell.text) + "' (must be a whole number) correct it");
    return 0;
  }

  double number(const CsvCell& cell, int line, bool may_lack) {
    if (cell.text.empty() && may_lack) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, error] = std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), value);
    if (error == std::errc{} && end == cell.text.data() + cell.text.size() && std::isfinite(value)) return value;
    report_.add({line, cell.column}, "'" + excerpt(cell.text) + "' (must be a finite number" + (may_lack ? ", or empty" : "") + ") correct it");
    return 0;
  }

  Report& report_;
  std::size_t columns_ = 0;
  bool bad_header_ = false;
  std::vector<bool> is_feature_;  ///< by column after the fixed ones
  std::map<std::tuple<std::string, int, std::uint64_t>, int> seen_;
};

}  // namespace

std::string bank_csv(const Bank& bank) {
  std::string text = "experiment,point,seed,profile";
  for (const BankInput& input : bank.inputs) text += "," + heading(input.name, input.unit);
  for (const std::string& id : bank.features) text += "," + heading(id, unit_of(*feature_info(id)));
  text += "\n";
  for (const BankRow& row : bank.rows) {
    text += row.experiment + "," + std::to_string(row.point) + "," + std::to_string(row.seed) + "," + row.profile;
    for (const double value : row.inputs) text += "," + seven_digits(value);
    for (const double value : row.features) text += "," + seven_digits(value);
    text += "\n";
  }
  return text;
}

Read<Bank> read_bank(const std::string& file_name, const std::string& text) {
  const bool too_large = text.size() > kLargestBank;
  Report report(file_name, too_large ? "" : text);
  Bank bank;
  if (too_large) report.add({}, "file of " + std::to_string(text.size()) + " bytes (the limit is " + std::to_string(kLargestBank) + ") split it");
  else if (const auto bad = first_bad_byte(text)) report.add({}, "not a text file (the byte at offset " + std::to_string(*bad) + " is not UTF-8 text) give a bank.csv");
  else bank = BankReader(report).read(text);
  Read<Bank> out{.value = std::nullopt, .diagnostics = report.take()};
  if (out.diagnostics.empty()) out.value = std::move(bank);
  return out;
}

}  // namespace regolab::gap
