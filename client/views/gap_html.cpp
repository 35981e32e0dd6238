#include "client/views/gap_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/views/gap_text.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

constexpr const char* kStyle = R"css(
body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#1a1a1a;background:#fff}
h1{font-size:1.5rem;margin:0}h2{font-size:1.1rem;margin:2rem 0 .5rem}
.card{border-left:.5rem solid #0072b2;background:#f2f6fa;padding:1rem 1.25rem;margin:1rem 0}
.card.gap{border-color:#d55e00;background:#fdf3ec}.card.open{border-color:#999;background:#f5f5f5}
table{border-collapse:collapse;width:100%;font-size:.95rem}th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid #ddd;vertical-align:top}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}.bar{background:#ddd;height:.8rem;min-width:8rem}.bar i{display:block;height:100%;background:#0072b2}
.bar.z i{background:#d55e00}.quiet{color:#666;font-size:.9rem}
@media(prefers-color-scheme:dark){body{background:#15181c;color:#e6e6e6}.card{background:#1d252d}.card.gap{background:#2d211a}.card.open{background:#222}
td,th{border-color:#333}.bar{background:#333}.quiet{color:#aaa}}
@media print{body{margin:0}}
)css";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string bar(double share, const char* kind = "") {
  return fmt::format("<div class=\"bar {}\" role=\"img\" aria-label=\"{:.0f} %\"><i style=\"width:{:.1f}%\"></i></div>", kind, 100 * share, 100 * std::clamp(share, 0.0, 1.0));
}

std::string card(const pb::Diagnosis& d) {
  const bool open = d.verdict() == "CANNOT TELL" || d.verdict() == "ONE OF";
  std::string lines;
  for (const std::string& line : diagnosis_lines(d)) lines += fmt::format("<p>{}</p>", escaped(line));
  return fmt::format("<div class=\"card {}\"><h1>{}</h1>{}</div>", open ? "open" : d.verdict() == "NO GAP" ? "" : "gap", escaped(d.verdict()), lines);
}

std::string gap_map(const pb::Diagnosis& d) {
  double most = 4;
  for (const auto& g : d.where()) most = std::max(most, std::abs(g.z()));
  std::string rows;
  for (const auto& g : d.where()) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=n>{:+.1f}</td><td>{}</td><td class=n>{:.2g}</td></tr>", escaped(g.group()), escaped(g.text()), g.z(),
                        bar(std::abs(g.z()) / most, "z"), g.p_adjusted());
  }
  return "<h2>Where: each group beside what all the others foretell under the base model</h2><table><tr><th>group</th><th>the feature that is off most</th>"
         "<th class=n>sigma</th><th></th><th class=n>p, adjusted</th></tr>" + rows + "</table>";
}

std::string strength_cell(const pb::WeighedModel& m) {
  if (m.strength().empty()) return "";
  const auto& s = m.strength(0);
  const DoorUnit door = door_unit(s.unit_si());
  return fmt::format("{:.3g} ({:.3g} to {:.3g}) {}", s.median() * door.factor, s.low_05() * door.factor, s.high_95() * door.factor, s.unit_si() == "1" ? "" : escaped(door.name));
}

std::string ladder(const pb::Diagnosis& d) {
  std::string rows;
  for (const auto& m : d.models()) {
    const auto known = std::find_if(d.isolability().begin(), d.isolability().end(), [&](const auto& i) { return i.effect() == m.model(); });
    const std::string isolable = known == d.isolability().end() ? "" : fmt::format("{:.1f}", known->sigma());
    const std::string twin = known == d.isolability().end() || known->cosine() < 0.8 ? "" : fmt::format("{} ({:.2f})", escaped(known->twin()), known->cosine());
    rows += fmt::format("<tr><td>{}</td><td class=n>{:.3f}</td><td>{}</td><td class=n>{:.1f} ± {:.1f}</td><td>{}</td><td class=n>{}</td><td>{}</td></tr>", escaped(m.model()), m.probability(),
                        bar(m.probability()), m.log_z(), m.log_z_error(), strength_cell(m), isolable, twin);
  }
  return "<h2>Which: the ladder of causes</h2><table><tr><th>cause</th><th class=n>P</th><th></th><th class=n>log Z</th><th>strength, 90 %</th><th class=n>isolable, sigma</th>"
         "<th>looks like</th></tr>" + rows + "</table><p class=quiet>Isolable: what a typical shift of the effect is worth after the base model has been refitted, known before the "
         "measurements were looked at. Below 2 these tests cannot see it.</p>";
}

std::string measurements(const pb::ImportReply& measured) {
  std::string rows;
  for (const auto& f : measured.features()) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=n>{:.4g} ± {:.2g}{}</td><td>{}</td><td class=n>{}</td></tr>", escaped(f.group()), escaped(f.label()), f.shown(), f.shown_error(),
                        f.assumed() ? " assumed" : "", f.unit() == "1" ? "" : escaped(f.unit()), f.repeats());
  }
  return "<h2>What was measured</h2><table><tr><th>group</th><th>feature</th><th class=n>value</th><th>unit</th><th class=n>repeats</th></tr>" + rows + "</table>";
}

}  // namespace

std::string diagnosis_html(const pb::Diagnosis& d, const pb::ImportReply& measured) {
  std::string warnings;
  for (const std::string& warning : d.warnings()) warnings += fmt::format("<li>{}</li>", escaped(warning));
  return fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>Gap: {}</title><style>{}</style></head><body>"
                     "<p class=quiet>Gap between simulation and measurement: {}</p>{}{}{}{}{}<p class=quiet>Bank {}, physics version {}, sampler seed {}, {} features.</p></body></html>\n",
                     escaped(d.case_name()), kStyle, escaped(d.case_name()), card(d), gap_map(d), ladder(d), measurements(measured),
                     warnings.empty() ? "" : "<h2>Not used</h2><ul>" + warnings + "</ul>", escaped(d.bank()), d.physics_version(), d.seed(), d.features());
}

}  // namespace regolab::client
