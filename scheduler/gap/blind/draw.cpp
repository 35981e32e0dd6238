#include "scheduler/gap/blind/draw.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "scheduler/gap/blind/unknown_kinds.h"
#include "scheduler/gap/diagnosis.h"

namespace regolab::gap {
namespace {

// What no bank has: its specimens have 300 clusters, steps of 0.15, and seeds below 1000.
constexpr int kFewestClusters = 260, kMostClusters = 360;
constexpr double kShortestStep = 0.08, kLongestStep = 0.18;
constexpr double kFirstSeed = 1e6, kLastSeed = 1e12;

constexpr const char* kElements[] = {"2", "4", "6", "mixture"};
constexpr const char* kRotations[] = {"none", "x", "z", "xz"};

/// Over the box of the bank's null design, with its shares (scheduler/surrogate/campaign/points.awk): friction denser where it matters most,
/// a third under Earth's gravity.
BlindMaterial draw_material(Chance& chance) {
  BlindMaterial m;
  m.friction_deg = rounded(0.1 + 59.9 * std::pow(chance.uniform(), 1.4));
  m.normal_stiffness = rounded(chance.between(2.5e4, 1e5));
  m.normal_damping = rounded(chance.between(0.25, 1));
  m.tangential_stiffness = rounded(chance.between(2.5e4, 1e5));
  m.tangential_damping = rounded(chance.between(0.25, 1));
  m.largest_cm = rounded(chance.between(0.5, 2));
  m.elements = kElements[chance.below(4)];
  m.rotation = kRotations[chance.below(4)];
  m.gravity = chance.uniform() < 1.0 / 3 ? 9.8 : 1.63;
  return m;
}

/// The strength at share u of the prior.
double strength_at(const EffectInfo& effect, double u) {
  const double low = effect.prior_low, high = effect.prior_high;
  return rounded(effect.logarithmic ? low * std::pow(high / low, u) : low + (high - low) * u);
}

// Strata of the isolability of single effects [design Sec. 3]; of pairs, both halves belong to the last.
struct Stratum {
  double low, high;
  double off(double isolability) const { return std::max({low - isolability, isolability - high, 0.0}); }
};
constexpr Stratum kStrata[] = {{1, 2}, {2, 4}, {4, INFINITY}};
constexpr int kTries = 200;  // effects that no material of the box shows so clearly get the clearest that was met

void add_effect(Truth& truth, const EffectInfo& effect, double strength, Chance& chance) {
  truth.effects[std::string(effect.name)] = strength;
  for (const EffectInfo& law : all_effects()) {
    if (law.variant_of != effect.id || chance.coin()) continue;
    truth.variants[std::string(law.name)] = std::string(law.choices.back());
  }
}

const EffectInfo& member(const CauseMembers& cause, Chance& chance) { return *find_effect(cause.effects[chance.below(cause.effects.size())]); }

class Drawing {
 public:
  Drawing(const BlindPlan& plan, const std::string& secret, const Sight& sight) : plan_(plan), secret_(secret), sight_(sight), dealing_(secret, "deal") {}

  std::vector<Truth> all() {
    const Composition c = composition_of(plan_.cases);
    effects(c.effects);
    for (int k = 0; k < c.nulls; ++k) fresh(TruthKind::kNull);
    unknowns(c.unknowns);
    pairs(c.pairs);
    for (int k = 0; k < plan_.nulls; ++k) fresh(TruthKind::kNull).extra = true;
    std::ranges::sort(truths_, {}, &Truth::id);
    return std::move(truths_);
  }

 private:
  Chance chance(const Truth& truth, const char* of) const { return {secret_, truth.id + "/" + of}; }

  Truth& fresh(TruthKind kind) {
    Truth t{.id = dealing_.hex(10), .development = plan_.development, .kind = kind};
    Chance c = chance(t, "run");
    t.material = draw_material(c);
    t.particles = kFewestClusters + static_cast<int>(c.below(kMostClusters - kFewestClusters + 1));
    if (t.particles == 300) ++t.particles;
    t.step_fraction = rounded(c.between(kShortestStep, kLongestStep));
    for (int k = 0; k < plan_.specimens; ++k) t.seeds.push_back(static_cast<std::uint64_t>(c.between(kFirstSeed, kLastSeed)));
    t.nonce = c.hex(64);
    return truths_.emplace_back(std::move(t));
  }

  /// Materials and strengths until the weakest effect is as isolable as the stratum asks for; the nearest met where none is.
  template <class AddEffects>
  void draw_within(const Stratum& stratum, Truth& truth, const AddEffects& add_effects) {
    Chance own = chance(truth, "effect");
    std::optional<Truth> nearest;
    double least = INFINITY;
    for (int k = 0; k < kTries && least > 0; ++k) {
      Truth tried = truth;
      tried.material = draw_material(own);
      add_effects(tried, own);
      const double off = stratum.off(sight_(tried));
      if (!nearest || off < least) nearest = std::move(tried), least = off;
    }
    truth = std::move(*nearest);
  }

  /// Classes in turn, and strata in turn.
  void effects(int n) {
    const auto causes = all_causes();
    const auto turn = dealing_.order(causes.size());
    for (int k = 0; k < n; ++k) {
      const CauseMembers& cause = causes[turn[static_cast<std::size_t>(k) % turn.size()]];
      const auto round = static_cast<std::size_t>(k) / turn.size();
      draw_within(kStrata[(static_cast<std::size_t>(k) + round) % std::size(kStrata)], fresh(TruthKind::kEffect), [&](Truth& t, Chance& own) {
        const EffectInfo& effect = member(cause, own);
        add_effect(t, effect, strength_at(effect, own.uniform()), own);
      });
    }
  }

  void unknowns(int n) {
    const auto turn = dealing_.order(unknown_kinds().size());
    for (int k = 0; k < n; ++k) {
      Truth& t = fresh(TruthKind::kUnknown);
      Chance own = chance(t, "unknown");
      const UnknownKind& kind = unknown_kinds()[turn[static_cast<std::size_t>(k) % turn.size()]];
      t.unknown = std::string(kind.name);
      kind.draw(own, t);
    }
  }

  void pairs(int n) {
    const auto causes = all_causes();
    for (int k = 0; k < n; ++k) {
      draw_within(kStrata[2], fresh(TruthKind::kPair), [&](Truth& t, Chance& own) {
        const auto turn = own.order(causes.size());
        for (const std::size_t which : {turn[0], turn[1]}) {
          const EffectInfo& effect = member(causes[which], own);
          add_effect(t, effect, strength_at(effect, own.uniform()), own);
        }
      });
    }
  }

  const BlindPlan plan_;
  const std::string& secret_;
  const Sight& sight_;
  Chance dealing_;
  std::vector<Truth> truths_;
};

}  // namespace

Composition composition_of(int cases) {
  const Composition whole;
  const int parts[] = {whole.effects, whole.nulls, whole.unknowns, whole.pairs};
  int out[4], left = cases;
  for (int k = 0; k < 4; ++k) out[k] = parts[k] * cases / 96, left -= out[k];
  for (; left > 0; --left) {
    int most = 0;
    for (int k = 1; k < 4; ++k) {
      if (parts[k] * cases - 96 * out[k] > parts[most] * cases - 96 * out[most]) most = k;
    }
    ++out[most];
  }
  return {out[0], out[1], out[2], out[3]};
}

std::vector<CauseMembers> all_causes() {
  std::vector<CauseMembers> out;
  for (const EffectInfo& effect : all_effects()) {
    if (effect.variant_of) continue;
    const std::string name(effect.name), cause = cause_class(name);
    const auto known = std::ranges::find(out, cause, &CauseMembers::cause);
    if (known == out.end())
      out.push_back({cause, {name}});
    else
      known->effects.push_back(name);
  }
  return out;
}

std::vector<Truth> draw_truths(const BlindPlan& plan, const std::string& secret, const Sight& sight) { return Drawing(plan, secret, sight).all(); }

}  // namespace regolab::gap
