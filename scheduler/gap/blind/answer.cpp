#include "scheduler/gap/blind/answer.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace regolab::gap {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kFormat = "regolab.gap-answer/1";
constexpr Verdict kVerdicts[] = {Verdict::kNoGap, Verdict::kEffect, Verdict::kOneOf, Verdict::kPair, Verdict::kNoneOfThese, Verdict::kCannotTell};

void add(const Diagnosis& d, Json& out) {
  out["verdict"] = name_of(d.verdict);
  out["classes"] = d.classes;
  for (const char* list : {"p", "strength", "where", "isolability"}) out[list] = Json::array();
  for (const Weighed& m : d.models) {
    out["p"].push_back({{"model", m.cause}, {"effect", m.model}, {"prob", m.probability}, {"logZ", m.log_z}, {"logZ_err", m.log_z_error}});
    for (const Strength& s : m.strength) {
      out["strength"].push_back({{"of", m.model}, {"effect", s.effect}, {"unit", s.unit}, {"median", s.median}, {"q05", s.low}, {"q95", s.high}});
    }
  }
  for (const GroupGap& g : d.where) {
    out["where"].push_back({{"group", g.group.text()},
                            {"feature", g.feature},
                            {"text", g.text},
                            {"shift_pct", g.shift_pct},
                            {"z", g.z},
                            {"p", g.p},
                            {"p_adj", g.p_adjusted}});
  }
  for (const Isolability& i : d.isolability)
    out["isolability"].push_back({{"effect", i.effect}, {"sigma", i.sigma}, {"twin", i.twin}, {"cosine", i.cosine}});
  out["adequacy"] = {{"p", d.adequacy}, {"threshold", d.adequacy_threshold}};
  out["features"] = d.features;
  out["warnings"] = d.warnings;
}

Json json_of(const Baselines& b) {
  Json out{{"lowest_rms", b.lowest_rms},
           {"bic", b.bic},
           {"nearest_pattern", b.nearest_pattern},
           {"base_misfit_p", b.base_misfit_p},
           {"refits", Json::array()}};
  for (const Refit& r : b.refits) {
    out["refits"].push_back({{"model", r.model},
                             {"rms", r.rms},
                             {"log_likelihood", r.log_likelihood},
                             {"parameters", r.parameters},
                             {"bic_prob", r.bic_probability},
                             {"cosine", r.cosine}});
  }
  return out;
}

double number(const Json& j) { return j.is_number() ? j.get<double>() : NAN; }

Diagnosis diagnosis_from(const Json& j) {
  Diagnosis out;
  for (const Verdict verdict : kVerdicts) {
    if (j.at("verdict") == name_of(verdict)) out.verdict = verdict;
  }
  out.classes = j.at("classes");
  for (const Json& m : j.at("p")) {
    out.models.push_back({.model = m.at("effect"),
                          .cause = m.at("model"),
                          .log_z = number(m.at("logZ")),
                          .log_z_error = number(m.at("logZ_err")),
                          .probability = number(m.at("prob")),
                          .strength = {}});
  }
  for (const Json& s : j.at("strength")) {
    for (Weighed& m : out.models) {
      if (s.at("of") == m.model)
        m.strength.push_back({s.at("effect"), s.at("unit"), number(s.at("median")), number(s.at("q05")), number(s.at("q95"))});
    }
  }
  for (const Json& g : j.at("where"))
    out.where.push_back({.group = {},
                         .feature = g.at("feature"),
                         .text = g.at("text"),
                         .shift_pct = number(g.at("shift_pct")),
                         .z = number(g.at("z")),
                         .p = number(g.at("p")),
                         .p_adjusted = number(g.at("p_adj"))});
  out.adequacy = number(j.at("adequacy").at("p")), out.adequacy_threshold = number(j.at("adequacy").at("threshold"));
  out.features = j.at("features");
  return out;
}

Baselines baselines_from(const Json& j) {
  Baselines out{.refits = {},
                .lowest_rms = j.at("lowest_rms"),
                .bic = j.at("bic"),
                .nearest_pattern = j.at("nearest_pattern"),
                .base_misfit_p = number(j.at("base_misfit_p"))};
  for (const Json& r : j.at("refits")) {
    out.refits.push_back({.model = r.at("model"),
                          .rms = number(r.at("rms")),
                          .log_likelihood = number(r.at("log_likelihood")),
                          .parameters = r.at("parameters"),
                          .bic_probability = number(r.at("bic_prob")),
                          .cosine = number(r.at("cosine"))});
  }
  return out;
}

}  // namespace

std::string answer_text(const Answer& a) {
  Json out{{"format", kFormat}, {"case", a.case_name}, {"problem", a.problem}};
  add(a.diagnosis, out);
  out["shrinkage"] = nullptr;
  out["baselines"] = json_of(a.baselines);
  out["provenance"] = {{"bank", a.source.bank},
                       {"measurements", a.source.measurements},
                       {"program", a.source.program},
                       {"seed", a.source.seed},
                       {"protection", a.source.protection}};
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Answer> answer_from(const std::string& text) {
  try {
    const Json j = Json::parse(text);
    if (j.at("format") == kFormat) {
      const Json& from = j.at("provenance");
      return Answer{j.at("case"),
                    j.at("problem"),
                    diagnosis_from(j),
                    baselines_from(j.at("baselines")),
                    {from.at("bank"), from.at("measurements"), from.at("program"), from.at("seed"), from.at("protection")},
                    j.at("where").empty() ? "" : j.at("where").front().at("group").get<std::string>()};
    }
  } catch (const Json::exception&) {
  }
  return Error{Code::kDataLoss, "no answer to a blind case (other format, or damaged) solve the case again"};
}

}  // namespace regolab::gap
