#include "client/views/gap_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/views/gap_text.h"
#include "vocab/units.h"

namespace regolab::client {
namespace {

constexpr const char* kStyle = R"css(
:root{color-scheme:light dark;--ink:#1a1a1a;--paper:#fff;--line:#ddd;--quiet:#555;--base:#b84a00;--repaired:#0072b2;--plain:#f2f6fa;--gap:#fdf3ec;--open:#f5f5f5}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e6e6e6;--paper:#15181c;--line:#3a3f45;--quiet:#aaa;--base:#ff9a57;--repaired:#63b8f2;--plain:#1d252d;--gap:#2d211a;--open:#23262a}}
body{font:1rem/1.5 system-ui,sans-serif;max-width:64rem;margin:2rem auto;padding:0 1rem;color:var(--ink);background:var(--paper)}
h1{font-size:1.5rem;margin:0}h2{font-size:1.1rem;margin:2rem 0 .5rem}
.card{border-left:.5rem solid var(--repaired);background:var(--plain);padding:1rem 1.25rem;margin:1rem 0}
.card.gap{border-color:var(--base);background:var(--gap)}.card.open{border-color:#999;background:var(--open)}.card h2{margin:0 0 .3rem}.card p{margin:.3rem 0}
.wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-size:.95rem}th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid var(--line);vertical-align:top}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.bar{background:var(--line);height:.8rem;min-width:6rem}.bar i{display:block;height:100%;background:var(--repaired)}.bar.z i{background:var(--base)}
.quiet{color:var(--quiet);font-size:.9rem}.figure{font-size:2rem;font-weight:600;line-height:1.2}
.curves{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(28rem,100%),1fr));gap:.75rem 1.5rem}.pair{display:grid;grid-template-columns:1fr 1fr;gap:.25rem}figure{margin:0}
svg{width:100%;height:auto;font:10px system-ui,sans-serif}svg text{fill:var(--quiet)}svg .t{fill:var(--ink);font-size:11px}
.g{stroke:var(--line);stroke-width:.6;fill:none}.c{stroke:var(--ink);stroke-width:.8;opacity:.55;fill:none}.m{stroke:var(--ink);fill:none}.md{fill:var(--ink)}
.b{--c:var(--base)}.r{--c:var(--repaired)}.l{stroke:var(--c);stroke-width:1.6;fill:none}.l.b{stroke-dasharray:5 3}.f{fill:var(--c);opacity:.16}.d{fill:var(--paper);stroke:var(--c);stroke-width:1.4}
.legend{display:flex;flex-wrap:wrap;gap:.3rem 1.5rem;font-size:.9rem}.key::before{content:"";display:inline-block;width:1.6rem;border-top:3px solid var(--ink);margin-right:.4rem;vertical-align:.25em}
.key.b::before{border-top:3px dashed var(--base)}.key.r::before{border-color:var(--repaired)}
@media print{@page{margin:15mm}html{font-size:9.5px}svg,svg .t{font-size:13px}body{margin:0;max-width:none;padding:0;print-color-adjust:exact;-webkit-print-color-adjust:exact}h2{break-after:avoid}.card,.pair,tr{break-inside:avoid}
.curves{grid-template-columns:1fr 1fr}.wide{overflow:visible}td,th{padding:.15rem .4rem}}
)css";

std::string bar(double share, const char* kind = "") {
  return fmt::format("<div class=\"bar {}\" role=\"img\" aria-label=\"{:.0f} %\"><i style=\"width:{:.1f}%\"></i></div>", kind, 100 * share, 100 * std::clamp(share, 0.0, 1.0));
}

std::string card(const pb::Diagnosis& d) {
  const bool open = d.verdict() == "CANNOT TELL" || d.verdict() == "ONE OF";
  std::string lines;
  for (const std::string& line : diagnosis_lines(d)) {
    const std::size_t end = line.find(' ');  // of its first word, which says what it answers
    lines += fmt::format("<p><b>{}</b>{}</p>", html_escaped(line.substr(0, end)), html_escaped(line.substr(std::min(end, line.size()))));
  }
  return fmt::format("<div class=\"card {}\"><h1>{}</h1>{}</div>", open ? "open" : d.verdict() == "NO GAP" ? "" : "gap", html_escaped(d.verdict()), lines);
}

std::string gap_map(const pb::Diagnosis& d) {
  double most = 4;
  for (const auto& g : d.where()) most = std::max(most, std::abs(g.z()));
  std::string rows;
  for (const auto& g : d.where()) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=n>{:+.1f}</td><td>{}</td><td class=n>{:.2g}</td></tr>", html_escaped(g.group()), html_escaped(g.text()), g.z(),
                        bar(std::abs(g.z()) / most, "z"), g.p_adjusted());
  }
  return "<h2>Where: each group beside what all the others foretell under the base model</h2><div class=wide><table><tr><th>group</th><th>the feature that is off most</th>"
         "<th class=n>sigma</th><th></th><th class=n>p, adjusted</th></tr>" + rows + "</table></div>";
}

std::string strength_cell(const pb::WeighedModel& m) {
  if (m.strength().empty()) return "";
  const auto& s = m.strength(0);
  const DoorUnit door = door_unit(s.unit_si());
  return fmt::format("{:.3g} ({:.3g} to {:.3g}) {}", s.median() * door.factor, s.low_05() * door.factor, s.high_95() * door.factor, s.unit_si() == "1" ? "" : html_escaped(door.name));
}

std::string ladder(const pb::Diagnosis& d) {
  std::string rows;
  for (const auto& m : d.models()) {
    const auto known = std::find_if(d.isolability().begin(), d.isolability().end(), [&](const auto& i) { return i.effect() == m.model(); });
    const std::string isolable = known == d.isolability().end() ? "" : fmt::format("{:.1f}", known->sigma());
    const std::string twin = known == d.isolability().end() || known->cosine() < 0.8 ? "" : fmt::format("{} ({:.2f})", html_escaped(known->twin()), known->cosine());
    rows += fmt::format("<tr><td>{}</td><td class=n>{:.3f}</td><td>{}</td><td class=n>{:.1f} ± {:.1f}</td><td>{}</td><td class=n>{}</td><td>{}</td></tr>", html_escaped(m.model()), m.probability(),
                        bar(m.probability()), m.log_z(), m.log_z_error(), strength_cell(m), isolable, twin);
  }
  return "<h2>Which: the ladder of causes</h2><div class=wide><table><tr><th>cause</th><th class=n>P</th><th></th><th class=n>log Z</th><th>strength, 90 %</th><th class=n>isolable, sigma</th>"
         "<th>looks like</th></tr>" + rows + "</table></div><p class=quiet>Isolable: what a typical shift of the effect is worth after the base model has been refitted, known before the "
         "measurements were looked at. Below 2 these tests cannot see it.</p>";
}

std::string number(double value, double error) { return fmt::format("{:.4g} ± {:.2g}", value, error); }

std::string measurements(const pb::ImportReply& measured, const pb::Diagnosis& d) {
  std::string rows;
  for (const auto& f : measured.features()) {
    const auto fit = std::find_if(d.fits().begin(), d.fits().end(), [&](const auto& one) { return one.id() == f.id(); });
    const bool known = fit != d.fits().end();
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=n>{:.4g} ± {:.2g}{}</td><td class=n>{}</td><td class=n>{}</td><td>{}</td><td class=n>{}</td></tr>", html_escaped(f.group()),
                        html_escaped(f.label()), f.shown(), f.shown_error(), f.assumed() ? " assumed" : "", known ? number(fit->base(), fit->base_error()) : "",
                        known && fit->has_repaired() ? number(fit->repaired(), fit->repaired_error()) : "", f.unit() == "1" ? "" : html_escaped(f.unit()), f.repeats());
  }
  return "<h2>What was measured, and what the models make of it</h2><div class=wide><table><tr><th>group</th><th>feature</th><th class=n>measured</th><th class=n>base model</th>"
         "<th class=n>repaired</th><th>unit</th><th class=n>repeats</th></tr>" + rows + "</table></div>";
}

std::string heldout_table(const pb::Shrinkage& s) {
  std::string rows;
  for (const auto& f : s.features()) {
    rows += fmt::format("<tr><td>{}</td><td class=n>{}</td><td class=n>{}</td><td class=n>{}</td><td>{}</td></tr>", html_escaped(f.label()), number(f.measured(), f.measured_error()),
                        number(f.base(), f.base_error()), f.has_repaired() ? number(f.repaired(), f.repaired_error()) : "", f.unit() == "1" ? "" : html_escaped(f.unit()));
  }
  if (rows.empty()) return "";
  return "<details><summary>Every held-out feature</summary><div class=wide><table><tr><th>held out</th><th class=n>measured</th><th class=n>base model, new runs</th>"
         "<th class=n>repaired, new runs</th><th>unit</th></tr>" + rows + "</table></div></details>";
}

std::string shrinkage_card(const pb::Diagnosis& d) {
  if (!d.has_shrinkage()) {
    return d.repaired().empty() ? "" : "<div class=\"card open\"><h2>How far the gap shrinks</h2><p>Not measured yet: <code>regolab gap confirm</code> runs new DEM for it.</p></div>";
  }
  const pb::Shrinkage& s = d.shrinkage();
  std::string text = "<h2>How far the gap shrinks</h2>";
  if (s.has_s()) text += fmt::format("<p class=figure>{:.0f} %</p>", 100 * s.s());
  text += "<p>" + html_escaped(shrinkage_line(d)) + ".</p>";
  text += fmt::format("<p class=quiet>Gap of the re-calibrated base model: {:.2f} errors of measurement (chance alone: up to {:.2f})", s.base_gap(), s.base_gap_noise_95());
  if (s.has_repaired_gap()) text += fmt::format("; of the repaired one: {:.2f}", s.repaired_gap());
  text += fmt::format(". {} draws of each posterior, each a specimen of its own.</p>", s.draws());
  for (const std::string& warning : s.warnings()) text += "<p class=quiet>" + html_escaped(warning) + "</p>";
  return fmt::format("<div class=\"card {}\">{}{}</div>", s.has_s() ? "" : "open", text, heldout_table(s));
}

std::string next_card(const pb::Diagnosis& d) {
  if (d.next_tests().empty()) return "";
  std::string rows;
  for (const auto& t : d.next_tests()) {
    rows += fmt::format("<tr><td>{}</td><td class=n>{}</td><td class=n>{:.3g}</td><td>{}</td></tr>", html_escaped(t.test()),
                        t.has_eig_nats() ? fmt::format("{:.2f} ± {:.2f}", t.eig_nats(), t.eig_error()) : "not foretold", t.hours(),
                        html_escaped(fmt::format("{}", fmt::join(t.splits().begin(), t.splits().end(), "; "))));
  }
  return fmt::format("<div class=\"card open\"><h2>What would settle it</h2><p class=quiet>{:.2f} nat are open between the causes. Hours of a laboratory are assumed.</p><div class=wide><table>"
                     "<tr><th>test</th><th class=n>expected to tell, nat</th><th class=n>hours</th><th>tells apart</th></tr>{}</table></div></div>", d.open_nats(), rows);
}

std::string blind_card(const std::string& record) {
  if (record.empty()) return "";
  return "<div class=\"card\"><h2>How far to trust it: the blind record</h2><p class=quiet>Cases made by our own code, whose effect was sealed until every case had "
         "its one answer.</p><div class=wide><pre>" + html_escaped(record) + "</pre></div></div>";
}

std::string not_used(const pb::Diagnosis& d) {
  std::string warnings;
  for (const std::string& warning : d.warnings()) warnings += fmt::format("<li>{}</li>", html_escaped(warning));
  return warnings.empty() ? "" : "<h2>Not used</h2><ul>" + warnings + "</ul>";
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else if (c == '\'') out += "&#39;";
    else out += c;
  }
  return out;
}

std::string diagnosis_html(const GapReport& report) {
  const pb::Diagnosis& d = report.stored.diagnosis();
  const std::string name = html_escaped(d.case_name());
  const std::string held = d.held_out().empty() ? "" : fmt::format(" Fitted without {}.", html_escaped(fmt::format("{}", fmt::join(d.held_out().begin(), d.held_out().end(), ", "))));
  return fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>Gap: {}</title><style>{}</style></head><body>"
                     "<p class=quiet>Gap between simulation and measurement: {}</p>", name, kStyle, name) +
         card(d) + shrinkage_card(d) + gap_map(d) + ladder(d) + curves_html(report.stored) + next_card(d) + measurements(report.stored.measured(), d) + not_used(d) +
         blind_card(report.blind_record) +
         fmt::format("<p class=quiet>Diagnosis {}, bank {}, kernels {}, method {}, physics version {}, sampler seed {}, {} features.{}</p></body></html>\n", html_escaped(d.id().substr(0, 12)),
                     html_escaped(d.bank()), html_escaped(d.kernels()), html_escaped(d.method()), d.physics_version(), d.seed(), d.features(), held);
}

}  // namespace regolab::client
