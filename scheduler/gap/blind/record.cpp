#include "scheduler/gap/blind/record.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace regolab::gap {
namespace {

using Json = nlohmann::ordered_json;

std::string shown(double v) {
  if (!std::isfinite(v)) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

std::string cell_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string joined(const std::map<std::string, double>& items) {
  std::string out;
  for (const auto& [name, value] : items) out += (out.empty() ? "" : ";") + name + "=" + shown(value);
  return out;
}

std::string variants_of(const Truth& t) {
  std::string out;
  for (const auto& [name, law] : t.variants) out += (out.empty() ? "" : ";") + law;
  return out;
}

Json json_of(const Interval& i) {
  if (i.n == 0) return nullptr;
  return {{"value", i.value}, {"low_95", i.low}, {"high_95", i.high}, {"n", i.n}};
}

std::string text_of(const Interval& i) {
  return i.n == 0 ? "not measured" : shown(i.value) + " (" + shown(i.low) + " to " + shown(i.high) + ", n = " + std::to_string(i.n) + ")";
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

}  // namespace

std::string record_csv(const std::vector<Mark>& marks) {
  std::string out =
      "case,set,tier,kind,truth,effects_si,variant,unknown,parameters,isolability,verdict,named,right,strictly_right,p_truth,log_score,brier,"
      "confidence,strength_of,unit,strength_truth,"
      "strength_median,strength_q05,strength_q95,strength_log_error,strength_covered,moved_group,where_right,shrinkage,shrinkage_q05,shrinkage_q95,"
      "adequacy_p,lowest_rms,bic,p_truth_bic,"
      "nearest_pattern,particles,step_fraction,problem,protection\n";
  const auto flag = [](bool yes) { return std::string(yes ? "1" : "0"); };
  for (const Mark& m : marks) {
    const Truth& t = m.truth;
    std::vector<std::string> cells{t.id,
                                   t.development ? "development" : "blind",
                                   t.extra ? "extra" : "main",
                                   std::string(name_of(t.kind)),
                                   m.answer,
                                   joined(t.effects),
                                   variants_of(t),
                                   t.unknown,
                                   joined(t.parameters),
                                   m.gap ? shown(m.gap->isolability) : "",
                                   m.verdict,
                                   m.ours.named,
                                   flag(m.right),
                                   flag(m.strictly_right),
                                   shown(m.ours.p.at(m.answer)),
                                   shown(log_score(m.ours, m.answer)),
                                   shown(brier(m.ours, m.answer)),
                                   shown(m.declared_confidence)};
    if (m.strength) {
      const StrengthMark& s = *m.strength;
      for (const std::string& cell : {s.effect, s.unit, shown(s.truth), shown(s.median), shown(s.low), shown(s.high),
                                      std::isfinite(s.log_error()) ? shown(s.log_error()) : std::string("wrong sign"), flag(s.covered())})
        cells.push_back(cell);
    } else {
      cells.insert(cells.end(), 8, "");
    }
    cells.push_back(m.gap ? m.gap->moved : ""), cells.push_back(m.where ? flag(*m.where) : "");
    const MeasuredShrinkage shrunk = m.shrinkage.value_or(MeasuredShrinkage{NAN, NAN, NAN});
    for (const double s : {shrunk.s, shrunk.low, shrunk.high}) cells.push_back(shown(s));
    cells.push_back(shown(m.adequacy));
    cells.push_back(m.baselines.at("lowest_rms").named), cells.push_back(m.baselines.at("bic").named),
        cells.push_back(shown(m.baselines.at("bic").p.at(m.answer)));
    cells.push_back(m.baselines.at("nearest_pattern").named), cells.push_back(std::to_string(t.particles)), cells.push_back(shown(t.step_fraction)),
        cells.push_back(m.problem), cells.push_back(m.protection);
    for (std::size_t k = 0; k < cells.size(); ++k) out += (k ? "," : "") + cell_text(cells[k]);
    out += "\n";
  }
  return out;
}

std::string score_json(const Score& s) {
  Json out{{"format", "regolab.blind-score/1"}, {"development", s.development}, {"main_cases", s.cases}, {"extra_nulls", s.extra},
           {"not_answered", s.missing},         {"figures", Json::object()}};
  for (const Figure& f : s.figures) out["figures"][f.name] = {{"what", f.what}, {"target", f.target}, {"value", json_of(f.value)}};
  for (const MethodScore& m : s.methods) {
    out["methods"][m.name] = {{"top1", json_of(m.top1)},
                              {"log_score", json_of(m.log_score)},
                              {"brier", json_of(m.brier)},
                              {"log_score_less_ours", json_of(m.log_score_less_ours)},
                              {"brier_less_ours", json_of(m.brier_less_ours)}};
  }
  for (const auto& [kind, share] : s.unknowns) out["unknowns"][kind] = json_of(share);
  for (const auto& [cause, share] : s.effects) out["right_by_truth"][cause] = json_of(share);
  return out.dump(1) + "\n";
}

std::string score_text(const Score& s) {
  std::string out = s.development ? "DEVELOPMENT SET: drawn from a known seed, no part of any record\n" : "";
  out += std::to_string(s.cases) + " main cases and " + std::to_string(s.extra) + " extra nulls" +
         (s.missing > 0 ? "; PARTIAL: " + std::to_string(s.missing) + " cases have no answer and stay sealed" : "") + "\n\n";
  for (const Figure& f : s.figures)
    out += padded(f.name, 24) + padded(text_of(f.value), 40) + padded(f.target.empty() ? "" : "asked for: " + f.target, 34) + f.what + "\n";
  out += "\nagainst the baselines, main cases (differences: above 0 where ours is better; 95 %)\n";
  for (const MethodScore& m : s.methods) {
    out += padded(m.name, 18) + "top-1 " + padded(shown(m.top1.value), 8) + "log score " + padded(shown(m.log_score.value), 8) + "Brier " +
           padded(shown(m.brier.value), 8);
    if (m.name != "ours")
      out += "log score less ours " + shown(m.log_score_less_ours.value) + " (" + shown(m.log_score_less_ours.low) + " to " +
             shown(m.log_score_less_ours.high) + "), Brier less ours " + shown(m.brier_less_ours.value) + " (" + shown(m.brier_less_ours.low) +
             " to " + shown(m.brier_less_ours.high) + ")";
    out += "\n";
  }
  out += "\nright, by truth\n";
  for (const auto& list : {s.effects, s.unknowns}) {
    for (const auto& [name, share] : list) out += "  " + padded(name, 24) + text_of(share) + "\n";
  }
  return out;
}

}  // namespace regolab::gap
