/// What is withheld of a blind case: the material, what departs from the base model, and how it was run.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vocab/result.h"

namespace regolab::gap {

/// Micro-parameters in the units that designs are written in; N_E and rotation as designs name them.
struct BlindMaterial {
  double friction_deg = 0;          ///< theta_F
  double normal_stiffness = 0;      ///< K_N [N/m]
  double normal_damping = 0;        ///< eta_N [N s/m]
  double tangential_stiffness = 0;  ///< K_T [N/m]
  double tangential_damping = 0;    ///< eta_T [N s/m]
  double largest_cm = 0;            ///< L_S
  double gravity = 0;               ///< [m/s2]
  std::string elements, rotation;

  bool operator==(const BlindMaterial&) const = default;
};

enum class TruthKind { kNull, kEffect, kPair, kUnknown };
std::string_view name_of(TruthKind kind);  ///< "null", "effect", "pair", "unknown"

struct Truth {
  std::string id;            ///< random hexadecimal digits
  bool development = false;  ///< drawn from a seed that is known: never part of a record
  bool extra = false;        ///< of the extra nulls
  TruthKind kind = TruthKind::kNull;
  std::map<std::string, double> effects;        ///< of the library, strengths in SI
  std::map<std::string, std::string> variants;  ///< "rolling_variant" -> "iwashita_oda"
  std::string unknown;                          ///< a kind of unknown_kinds.h
  std::map<std::string, double> parameters;     ///< of that kind
  BlindMaterial material;
  int particles = 0;
  double step_fraction = 0;
  std::vector<std::uint64_t> seeds;  ///< of the specimens
  std::string nonce;                 ///< 64 hexadecimal digits, so that nobody can guess the text behind a commitment

  bool operator==(const Truth&) const = default;
};

/// The right answer: "none", a class of causes, "a+b" (in alphabetical order), "unknown".
std::string answer_of(const Truth& truth);

/// The text that is committed to (its SHA-256) and, once revealed, published as it is.
std::string truth_text(const Truth& truth);
/// kDataLoss: not such a text.
Result<Truth> truth_from(const std::string& text);

}  // namespace regolab::gap
