#include "scheduler/gap/verdict.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace regolab::gap {
namespace {

// Prior probabilities; single effects share what is left by class, so that a class with two ways to be has no more than the others. Pairs
// share theirs over all that there can be, tried or not.
constexpr double kPriorNone = 0.20, kPriorUnknown = 0.15, kPriorPairs = 0.10;
constexpr double kSure = 0.7, kUnknownSure = 0.5, kTogether = 0.9;
constexpr double kPairBetter = 2.3;  // [nat] of log Z: a pair that explains no more than its better half has an idle one
constexpr double kLeastIsolability = 2, kLeastLearned = 0.3;  // [sigma], [nat]
constexpr std::size_t kMostNamed = 6;
constexpr double kVague = 0.6;  // of 45 known cases the five beyond it were named wrongly, four of them unknowns; true causes had 0.5 at most
constexpr double kWorthSaying = 0.1;

bool is_pair(const std::string& cause) { return cause.find('+') != std::string::npos; }

double pairs_among(double n) { return std::max(1.0, 0.5 * n * (n - 1)); }

/// How many models a class has, and how many classes are single effects.
struct Classes {
  std::map<std::string, int> members;
  double singles = 0;
};
Classes classes_of(const std::vector<Weighed>& models) {
  Classes out;
  for (const Weighed& m : models) ++out.members[m.cause];
  for (const auto& [cause, n] : out.members) out.singles += cause != "none" && cause != "unknown" && !is_pair(cause) ? 1 : 0;
  return out;
}

/// How far the posterior has moved from the prior [nat].
double learned(const std::vector<Weighed>& models) {
  const double singles = classes_of(models).singles;
  double sum = 0;
  for (const auto& [cause, p] : by_class(models)) {
    if (p > 0) sum += p * std::log(p / prior_of(cause, singles));
  }
  return sum;
}

/// An idle half takes probability from what it stands beside: for the verdict, a pair no better than its better half is that half.
std::vector<Weighed> without_idle_halves(std::vector<Weighed> models) {
  for (Weighed& m : models) {
    if (!is_pair(m.cause)) continue;
    const auto plus = m.model.find('+');
    const Weighed* better = nullptr;
    for (const Weighed& s : models) {
      const bool half = s.model == m.model.substr(0, plus) || s.model == m.model.substr(plus + 1);
      if (half && (better == nullptr || s.log_z > better->log_z)) better = &s;
    }
    if (better != nullptr && m.log_z < better->log_z + kPairBetter) m.cause = better->cause;
  }
  return models;
}

/// The halves of a pair of classes, first the one that explains more alone.
std::vector<std::string> halves_of(const std::string& pair, const std::vector<Weighed>& models) {
  const auto alone = [&](const std::string& cause) {
    double best = -INFINITY;
    for (const Weighed& m : models) best = m.cause == cause ? std::max(best, m.log_z) : best;
    return best;
  };
  const std::string a = pair.substr(0, pair.find('+')), b = pair.substr(pair.find('+') + 1);
  return alone(b) > alone(a) ? std::vector{b, a} : std::vector{a, b};
}

/// The fewest classes that hold nine tenths of the probability; of a pair, both halves.
std::vector<std::string> together(const std::vector<std::pair<std::string, double>>& classes, const std::vector<Weighed>& models) {
  std::vector<std::string> out;
  const auto name = [&](const std::string& cause) {
    if (std::ranges::find(out, cause) == out.end()) out.push_back(cause);
  };
  double sum = 0;
  for (const auto& [cause, share] : classes) {
    if (sum >= kTogether) break;
    if (!is_pair(cause)) name(cause);
    else
      for (const std::string& half : halves_of(cause, models)) name(half);
    sum += share;
  }
  return out;
}

}  // namespace

double prior_of(const std::string& cause, double singles) {
  if (cause == "none") return kPriorNone;
  if (cause == "unknown") return kPriorUnknown;
  if (is_pair(cause)) return kPriorPairs / pairs_among(singles);
  return (1 - kPriorNone - kPriorUnknown - kPriorPairs) / singles;
}

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[] = {"NO GAP", "EFFECT", "ONE OF", "PAIR", "NONE OF THESE", "CANNOT TELL"};
  return kNames[static_cast<int>(verdict)];
}

std::string cause_class(const std::string& effect) {
  if (const auto plus = effect.find('+'); plus != std::string::npos) {
    const std::string a = cause_class(effect.substr(0, plus)), b = cause_class(effect.substr(plus + 1));
    return std::min(a, b) + "+" + std::max(a, b);
  }
  if (effect.starts_with("lateral_stress_offset")) return "lateral_stress_offset";
  if (effect.starts_with("preparation_")) return "preparation";
  if (effect == "frame_compliance" || effect == "seating" || effect.starts_with("load_cell_")) return "apparatus";
  return effect;
}

void weigh(std::vector<Weighed>& models, double temperature) {
  const Classes classes = classes_of(models);
  double top = -INFINITY, sum = 0;
  for (Weighed& m : models) {
    // A pair of classes is tried in few of its ways: each has the share of all of them that it has of those tried.
    m.probability = std::log(prior_of(m.cause, classes.singles) / classes.members.at(m.cause)) + m.log_z / temperature;
    top = std::max(top, m.probability);
  }
  for (Weighed& m : models) sum += m.probability = std::exp(m.probability - top);
  for (Weighed& m : models) m.probability /= sum;
  std::ranges::sort(models, std::greater{}, &Weighed::probability);
}

void doubt(std::vector<Weighed>& models, double adequacy) {
  if (adequacy >= std::exp(-1.0)) return;
  const double fits = -std::exp(1.0) * adequacy * std::log(adequacy), other = kPriorUnknown / (1 - kPriorUnknown) * (1 / fits - 1);
  double named = 0;
  for (const Weighed& m : models) named += m.cause != "unknown" ? m.probability : 0;
  for (Weighed& m : models) m.probability = (m.probability + (m.cause == "unknown" ? named * other : 0)) / (1 + named * other);
  std::ranges::sort(models, std::greater{}, &Weighed::probability);
}

void mistrust(std::vector<Weighed>& models) {
  double moved = 0;
  for (Weighed& m : models) {
    if (m.cause == "unknown" || m.vague < kVague) continue;
    moved += m.vague * m.probability;
    m.probability *= 1 - m.vague;
  }
  for (Weighed& m : models) m.probability += m.cause == "unknown" ? moved : 0;
  std::ranges::sort(models, std::greater{}, &Weighed::probability);
}

std::vector<std::pair<std::string, double>> by_class(const std::vector<Weighed>& models) {
  std::vector<std::pair<std::string, double>> out;
  for (const Weighed& m : models) {
    const auto known = std::ranges::find(out, m.cause, &std::pair<std::string, double>::first);
    if (known == out.end()) out.emplace_back(m.cause, m.probability);
    else known->second += m.probability;
  }
  std::ranges::sort(out, std::greater{}, &std::pair<std::string, double>::second);
  return out;
}

void decide(Diagnosis& d) {
  const auto classes = by_class(without_idle_halves(d.models));
  const bool isolable = std::ranges::any_of(d.isolability, [](const Isolability& i) { return i.sigma >= kLeastIsolability; });
  const auto& [best, p] = classes.front();
  d.classes.clear();
  for (const Weighed& m : d.models) {
    if (m.cause == "unknown" || m.vague < kVague || m.probability < kWorthSaying) continue;
    d.warnings.push_back(m.model + " fits by what our runs do not know of it (" + std::to_string(std::lround(100 * m.vague)) +
                         " % of the variance), as a cause does that is in no library: its probability was shared with it");
  }
  if (!isolable || learned(d.models) < kLeastLearned) {
    d.verdict = Verdict::kCannotTell;
  } else if ((best == "unknown" && p >= kUnknownSure) || d.adequacy < d.adequacy_threshold) {
    d.verdict = Verdict::kNoneOfThese;
    d.classes = {"unknown"};
  } else if (p < kSure || (is_pair(best) && !d.same_code)) {
    d.classes = together(classes, d.models);
    if (p >= kSure) d.warnings.push_back(best + " fits best together, but of what another code or a laboratory measured a second cause cannot be told from a law that is written otherwise");
    d.verdict = d.classes.size() > kMostNamed ? Verdict::kCannotTell : Verdict::kOneOf;
  } else if (is_pair(best)) {
    d.verdict = Verdict::kPair;
    d.classes = {best.substr(0, best.find('+')), best.substr(best.find('+') + 1)};
  } else {
    d.verdict = best == "none" ? Verdict::kNoGap : best == "unknown" ? Verdict::kNoneOfThese : Verdict::kEffect;
    d.classes = {best};
  }
}

}  // namespace regolab::gap
