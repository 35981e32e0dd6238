#include "scheduler/gap/blind/truth.h"

#include <nlohmann/json.hpp>
#include <set>

#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "regolab.blind-truth/1";
constexpr TruthKind kKinds[] = {TruthKind::kNull, TruthKind::kEffect, TruthKind::kPair, TruthKind::kUnknown};

Json json_of(const BlindMaterial& m) {
  return {{"theta_F_deg", m.friction_deg},
          {"K_N_N_per_m", m.normal_stiffness},
          {"eta_N_N_s_per_m", m.normal_damping},
          {"K_T_N_per_m", m.tangential_stiffness},
          {"eta_T_N_s_per_m", m.tangential_damping},
          {"L_S_cm", m.largest_cm},
          {"N_E", m.elements},
          {"rotation", m.rotation},
          {"gravity_m_per_s2", m.gravity}};
}

BlindMaterial material_from(const Json& j) {
  return {.friction_deg = j.at("theta_F_deg"),
          .normal_stiffness = j.at("K_N_N_per_m"),
          .normal_damping = j.at("eta_N_N_s_per_m"),
          .tangential_stiffness = j.at("K_T_N_per_m"),
          .tangential_damping = j.at("eta_T_N_s_per_m"),
          .largest_cm = j.at("L_S_cm"),
          .gravity = j.at("gravity_m_per_s2"),
          .elements = j.at("N_E"),
          .rotation = j.at("rotation")};
}

TruthKind kind_from(const std::string& name) {
  for (const TruthKind kind : kKinds) {
    if (name_of(kind) == name) return kind;
  }
  throw Json::other_error::create(501, "kind " + name, static_cast<const Json*>(nullptr));
}

Truth truth_of(const Json& j) {
  Truth t{.id = j.at("case"),
          .development = j.at("development"),
          .extra = j.at("tier") == "extra",
          .kind = kind_from(j.at("kind")),
          .effects = j.at("effects_si"),
          .variants = j.at("variants"),
          .unknown = j.at("unknown"),
          .parameters = j.at("parameters"),
          .material = material_from(j.at("material")),
          .particles = j.at("particles"),
          .step_fraction = j.at("step_fraction"),
          .seeds = j.at("seeds"),
          .nonce = j.at("nonce")};
  return t;
}

}  // namespace

std::string_view name_of(TruthKind kind) {
  constexpr std::string_view kNames[] = {"null", "effect", "pair", "unknown"};
  return kNames[static_cast<int>(kind)];
}

std::string answer_of(const Truth& truth) {
  if (truth.kind == TruthKind::kNull) return "none";
  if (truth.kind == TruthKind::kUnknown) return "unknown";
  std::set<std::string> classes;
  for (const auto& [effect, strength] : truth.effects) classes.insert(cause_class(effect));
  std::string out;
  for (const std::string& name : classes) out += (out.empty() ? "" : "+") + name;
  return out;
}

std::string truth_text(const Truth& t) {
  Json j{{"format", kFormat},
         {"case", t.id},
         {"development", t.development},
         {"tier", t.extra ? "extra" : "main"},
         {"kind", name_of(t.kind)},
         {"effects_si", t.effects},
         {"variants", t.variants},
         {"unknown", t.unknown},
         {"parameters", t.parameters},
         {"material", json_of(t.material)},
         {"particles", t.particles},
         {"step_fraction", t.step_fraction},
         {"seeds", t.seeds},
         {"nonce", t.nonce}};
  return j.dump(1) + "\n";
}

Result<Truth> truth_from(const std::string& text) {
  try {
    const Json j = Json::parse(text);
    if (j.at("format") == kFormat) return truth_of(j);
  } catch (const Json::exception&) {
  }
  return Error{Code::kDataLoss, "no truth of a blind case (other format, or damaged) take the text as it was written"};
}

}  // namespace regolab::gap
