#include "client/views/gap_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "client/table_print.h"
#include "client/views/gap_next.h"
#include "vocab/units.h"

namespace regolab::client {

std::string import_text(const pb::ImportReply& reply) {
  std::string text = fmt::format("{}: {} numbers and {} curves, {} features\n\n", reply.name(), reply.scalars(), reply.curves(), reply.features_size());
  Table table({{.title = "feature", .align = Align::kLeft}, {.title = "value"}, {.title = "± error"}, {.title = "unit", .align = Align::kLeft},
               {.title = "repeats"}, {.title = "compared as"}, {.title = "± error"}, {.title = "where", .align = Align::kLeft}});
  for (const auto& f : reply.features()) {
    table.add({f.id(), fmt::format("{:.4g}", f.shown()), fmt::format("{:.2g}{}", f.shown_error(), f.assumed() ? " assumed" : ""), f.unit() == "1" ? "" : f.unit(),
               std::to_string(f.repeats()), fmt::format("{}{:.4g}", f.logarithm() ? "ln " : "", f.value()), fmt::format("{:.2g}", f.standard_error()), f.group()});
  }
  text += table.text();
  if (!reply.unused().empty()) text += "\nnot used\n";
  for (const auto& entry : reply.unused()) text += fmt::format("  {}: {}\n", entry.id(), entry.why());
  return text;
}

namespace {

std::string strength_text(const pb::EffectStrength& s) {
  const DoorUnit door = door_unit(s.unit_si());
  const std::string unit = s.unit_si() == "1" ? "" : " " + std::string(door.name);
  return fmt::format("{} {:.3g}{} ({:.3g} to {:.3g})", s.effect(), s.median() * door.factor, unit, s.low_05() * door.factor, s.high_95() * door.factor);
}

std::string where_line(const pb::Diagnosis& d) {
  constexpr int kShown = 4;
  std::string text;
  int found = 0;
  for (const auto& g : d.where()) {
    if (g.p_adjusted() >= 0.1) continue;
    if (found++ < kShown) text += (text.empty() ? "" : "; ") + g.text();
  }
  if (found > kShown) text += fmt::format("; and {} more groups", found - kShown);
  return text.empty() ? "nowhere surely: what each group measures is what the others foretell" : text;
}

std::string which_line(const pb::Diagnosis& d) {
  if (d.verdict() == "NONE OF THESE" && d.adequacy_p() < d.adequacy_threshold()) return d.verdict() + ": the best of them, " + d.models(0).model() + ", leaves a misfit that chance does not";
  std::string text = d.verdict();
  if (d.verdict() == "PAIR") {
    text += fmt::format(": {} together (P = {:.2f})", fmt::join(d.classes(), " and "), d.models(0).probability());
    for (const auto& s : d.models(0).strength()) text += "; " + strength_text(s);
    return text;
  }
  for (int k = 0; k < d.classes_size(); ++k) {
    const std::string among = "+" + d.classes(k) + "+";  // alone, or as half of a pair
    double p = 0;
    for (const auto& m : d.models()) p += ("+" + m.cause() + "+").find(among) != std::string::npos ? m.probability() : 0;
    text += fmt::format("{}{} (P = {:.2f})", k == 0 ? ": " : ", ", d.classes(k), p);
  }
  if (d.classes_size() != 1) return text;
  const auto alone = std::ranges::find(d.models(), d.classes(0), &pb::WeighedModel::cause);
  if (alone != d.models().end() && alone->strength_size() > 0) text += "; " + strength_text(alone->strength(0));
  return text;
}

}  // namespace

std::vector<std::string> diagnosis_lines(const pb::Diagnosis& d) {
  return {"where   " + where_line(d), "which   " + which_line(d), "shrinks " + shrinkage_line(d),
          fmt::format("sure    {} features, misfit of the best model p = {:.2g}{}", d.features(), d.adequacy_p(),
                      d.adequacy_p() < d.adequacy_threshold() ? ": it does not explain them" : ""),
          next_line(d)};
}

std::string where_text(const pb::Diagnosis& d) {
  Table table({{"group", "", Align::kLeft}, {"off most", "", Align::kLeft}, {"off by", "sigma"}, {"p, adjusted"}});
  for (const auto& g : d.where()) table.add({g.group(), g.text(), fmt::format("{:+.1f}", g.z()), fmt::format("{:.2g}", g.p_adjusted())});
  return "where   " + where_line(d) + "\n\n" + table.text();
}

std::string diagnosis_text(const pb::Diagnosis& d) {
  std::string text;
  for (const std::string& line : diagnosis_lines(d)) text += line + "\n";
  text += "\n";
  Table ladder({{"cause", "", Align::kLeft}, {"probability"}, {"log Z", "±"}, {"isolable", "sigma"}, {"strength, 90 %", "", Align::kLeft}});
  for (const auto& m : d.models()) {
    std::string isolable, twin;
    for (const auto& i : d.isolability()) {
      if (i.effect() == m.model()) isolable = fmt::format("{:.1f}", i.sigma());
    }
    ladder.add({m.model(), fmt::format("{:.3f}", m.probability()), fmt::format("{:.1f} ±{:.1f}", m.log_z(), m.log_z_error()), isolable,
                m.strength_size() > 0 ? strength_text(m.strength(0)) : ""});
  }
  return text + ladder.text();
}

}  // namespace regolab::client
