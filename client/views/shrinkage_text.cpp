#include <fmt/format.h>

#include "client/table_print.h"
#include "client/views/gap_text.h"

namespace regolab::client {
namespace {

std::string joined(const google::protobuf::RepeatedPtrField<std::string>& words) { return fmt::format("{}", fmt::join(words.begin(), words.end(), ", ")); }

std::string percent(double share) { return fmt::format("{:.0f}", 100 * share); }

std::string interval_of(const pb::Shrinkage& s) {
  if (!s.has_q95()) return "";
  return fmt::format(" (shrinkage {} to {} %)", s.has_q05() ? percent(s.q05()) : "below any", percent(s.q95()));
}

std::string number(double value, double error) { return fmt::format("{:.4g} ±{:.2g}", value, error); }

}  // namespace

std::string shrinkage_line(const pb::Diagnosis& d) {
  if (!d.has_shrinkage()) return d.repaired().empty() ? "not asked: no effect is named that could be added" : "not measured yet: `regolab gap confirm` runs new DEM for it";
  const pb::Shrinkage& s = d.shrinkage();
  if (!s.has_s()) return "not printed: " + s.undefined();
  const std::string promise = s.has_emulator_s() ? fmt::format("; the emulator promised {} %", percent(s.emulator_s())) : "";
  const std::string how_far = s.s() < 0 ? fmt::format("not: it grows by {} %", percent(-s.s())) : fmt::format("by {} %", percent(s.s()));
  return fmt::format("{}{} with {}, in {} new runs of each model on {}, which the fit had not seen{}", how_far, interval_of(s), s.model(), s.draws(), joined(s.heldout()), promise);
}

std::string shrinkage_text(const pb::Diagnosis& d) {
  const auto lines = diagnosis_lines(d);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const pb::Shrinkage& s = d.shrinkage();
  text += fmt::format("gap     {:.2f} errors of measurement with the re-calibrated base model", s.base_gap());
  text += s.has_repaired_gap() ? fmt::format(", {:.2f} with {}", s.repaired_gap(), s.model()) : "";
  text += fmt::format(" (chance alone: up to {:.2f})\n\n", s.base_gap_noise_95());
  Table table({{"held out", "", Align::kLeft}, {"measured"}, {"base model", "new runs"}, {"repaired", "new runs"}, {"unit", "", Align::kLeft}});
  for (const auto& f : s.features()) {
    table.add({f.label(), number(f.measured(), f.measured_error()), number(f.base(), f.base_error()), f.has_repaired() ? number(f.repaired(), f.repaired_error()) : "",
               f.unit() == "1" ? "" : f.unit()});
  }
  text += table.text();
  for (const std::string& warning : s.warnings()) text += warning + "\n";
  return text;
}

}  // namespace regolab::client
