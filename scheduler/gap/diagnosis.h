/// Where a simulation is wrong, which effect explains it, how strongly and how surely; or none of these; or that nobody can tell.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/gap/hypothesis.h"
#include "scheduler/gap/next.h"
#include "scheduler/gap/steps.h"

namespace regolab::gap {

enum class Verdict { kNoGap, kEffect, kOneOf, kPair, kNoneOfThese, kCannotTell };
std::string_view name_of(Verdict verdict);  ///< "NO GAP", "EFFECT", ...

/// What people call a cause: preparation_friction and preparation_gravity are `preparation`, the frame, the seating and the load cell
/// `apparatus`; "none" and "unknown" are themselves.
std::string cause_class(const std::string& effect);

struct Strength {
  std::string effect;
  std::string unit;  ///< SI
  double median = 0, low = 0, high = 0;  ///< 5 and 95 %
};

/// One material of a posterior, for runs of it.
struct Draw {
  std::vector<double> values;    // [n_axes] SI
  std::vector<double> strength;  // [n_causes] of the model, in the order of Weighed::strength
};
inline constexpr std::string_view kReadByAGauge = "_measured";  ///< ends the name of a lateral stress offset that is no secret
inline constexpr int kDraws = 12;  ///< kept of each model

struct Weighed {
  std::string model;  ///< "none", an effect's name, "a+b", "unknown"
  std::string cause;  ///< its class, "a+b" of a pair
  double log_z = 0, log_z_error = 0, probability = 0;
  std::vector<Strength> strength;
  std::vector<Draw> draws;  ///< kDraws of its posterior
  double vague = 0;  ///< share of the variance of what it foretells that is the emulator's error about its effects, mean over features
};

/// A group of features predicted from all the others under the base model.
struct GroupGap {
  Group group;
  std::string feature, text;  ///< the feature that is off most, and by how much: "sigma1 at 1.25 kPa is 38 % low"
  double shift_pct = 0;       ///< of that feature, in its own terms
  double z = 0;               ///< of the group: sqrt of its distance against what chance gives
  double p = 1, p_adjusted = 1;  ///< Benjamini and Hochberg
};

/// What a shift of one effect is worth after the base model has been refitted, before any data are seen.
struct Isolability {
  std::string effect;
  double sigma = 0;                  ///< standard deviations that no calibration absorbs, median over the prior
  double least = 0;                  ///< strength that these measurements notice [SI of the effect]
  bool seen = true;                  ///< false: not even the strongest of the prior is noticed
  std::string twin;                  ///< the effect whose pattern is most alike
  double cosine = 0;
};

struct Diagnosis {
  Verdict verdict = Verdict::kCannotTell;
  std::vector<std::string> classes;        ///< that the verdict names, most probable first
  std::vector<Weighed> models;             ///< most probable first
  std::vector<GroupGap> where;             ///< most surely off first
  std::vector<Isolability> isolability;
  double adequacy = 1;                     ///< p of the best model's misfit
  double adequacy_threshold = 0;
  std::vector<NextTest> next;              ///< what would tell more, best first
  double open = 0;                         ///< entropy of the causes' probabilities [nat]: the most that a test can tell
  std::vector<std::string> warnings;
  int features = 0;
  bool same_code = false;  ///< measured by this very code, whose laws are ours
};

struct DiagnosisOptions {
  SmcOptions smc{.particles = 400, .kept = 0.6, .moves = 3, .repeats = 1, .seed = 1};  ///< once more for what comes near the best
  double temperature = 2.2;      ///< of the evidence: fitted on 139 cases whose truth was known (log score, verdicts), which the emulators fail by more than chance
  double adequacy_threshold = 0.01;
  const StepMemory* memory = nullptr;  ///< of steps done before; outlives the call
};

/// "evidence: cohesion", 7 of 30; false ends the work.
using OnStep = std::function<bool(const std::string& what, int done, int of)>;

/// Errors: kFailedPrecondition (nothing to compare), kCancelled.
Result<Diagnosis> diagnose(const Emulator& emulator, const ObservationSet& set, const DiagnosisOptions& options, const OnStep& on_step = {});

/// The groups whose features the others do not foretell.
std::vector<GroupGap> locate(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, const SmcOptions& smc);

/// The "where" of a diagnosis with the same options, alone. kFailedPrecondition: nothing to compare.
Result<std::vector<GroupGap>> locate(const Emulator& emulator, const ObservationSet& set, const DiagnosisOptions& options);

std::vector<Isolability> isolability(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, std::uint64_t seed);

}  // namespace regolab::gap
