#include "scheduler/gap/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scheduler/gap/draws.h"
#include "scheduler/gap/quantile.h"
#include "scheduler/gap/tangent.h"
#include "scheduler/gap/verdict.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWider = 2.2;  // emulators of effects err together: on 11 development cases intervals as they came held 4 truths, so wide 8
constexpr int kReplicates = 1000;
constexpr int kParticlesOfWhere = 150;  // one fit for each group
constexpr std::uint64_t kUnseenStream = 3000;
constexpr double kNear = 7;  // [nat] of the best log Z: what may have a part in the verdict is sampled twice
constexpr std::uint64_t kAgainStream = 5000;
constexpr std::uint64_t kScreenStream = 4000;
constexpr std::size_t kPartnered = 2, kPairs = 6;  // best single effects that get a second one; pairs that are weighed
constexpr Index kScreen = 400;                     // draws that look for a second effect

/// An end of the 90 % interval, as far from the median as development cases ask for: in ratios or in differences, within the prior.
double widened(const EffectInfo& effect, double median, double end) {
  const double wide = effect.logarithmic ? median * std::pow(end / median, kWider) : median + kWider * (end - median);
  return std::clamp(wide, std::min(end, effect.prior_low), std::max(end, effect.prior_high));
}

Strength strength_of(const Emulator& emulator, std::size_t cause, const VectorXd& draws) {
  const EffectInfo& effect = *emulator.causes()[cause].effect;
  const std::vector<double> v(draws.data(), draws.data() + draws.size());
  const double median = quantile(v, 0.5);
  return {std::string(effect.name), std::string(effect.si), median, widened(effect, median, quantile(v, 0.05)), widened(effect, median, quantile(v, 0.95))};
}

/// Evenly over the particles.
std::vector<Draw> draws_of(const Likelihood& model, const MatrixXd& u, std::size_t n_causes) {
  std::vector<Draw> out;
  for (int k = 0; k < kDraws; ++k) {
    const MatrixXd one = u.col(k * u.cols() / kDraws), values = model.values(one);
    Draw draw{.values = {values.data(), values.data() + values.size()}, .strength = {}};
    for (std::size_t c = 0; c < n_causes; ++c) draw.strength.push_back(model.strength(one, c)[0]);
    out.push_back(std::move(draw));
  }
  return out;
}

/// Of the variance of what is foretold at draws of a posterior: the share that is the emulator's error about effects.
double vagueness_of(const Likelihood& model, const MatrixXd& draws) {
  double sum = 0;
  for (int k = 0; k < kDraws; ++k) {
    const MatrixXd u = draws.col(k * draws.cols() / kDraws);
    const Foretold p = model.predict(u);
    const VectorXd all = model.covariance(p, u, 0).diagonal();
    for (const Foretold::Shift& effect : p.effects) sum += (effect.wrong.col(0).array().square() / all.array()).mean() / kDraws;
  }
  return sum;
}

/// Share of data sets, drawn from the model at its best and fitted anew, that would misfit it more: without the new fit the measured set,
/// which has been fitted, would look better than chance [Hjort, Dahl and Steinbakk 2006, doi 10.1198/016214505000001393].
double adequacy_of(const Likelihood& model, const Comparison& comparison, const Posterior& posterior, std::uint64_t seed) {
  Index best = 0;
  posterior.log_likelihood.maxCoeff(&best);
  const Tangent tangent(model, comparison, posterior.u.col(best));
  const double measured = tangent.left(tangent.whitened(comparison.y - tangent.mean())).squaredNorm();
  int worse = 0;
  for (int r = 0; r < kReplicates; ++r) worse += tangent.left(normals(comparison.size(), seed, r)).squaredNorm() >= measured ? 1 : 0;
  return (worse + 1.0) / (kReplicates + 1.0);
}

/// The base model, each effect that these measurements can notice, and the unknown.
std::vector<Hypothesis> hypotheses_of(const Emulator& emulator, const std::vector<Isolability>& isolability) {
  std::vector<Hypothesis> out{{"none", {}, false, {}}};
  for (std::size_t c = 0; c < emulator.causes().size(); ++c) {
    if (!isolability[c].seen) continue;
    const Cause& cause = emulator.causes()[c];
    out.push_back({std::string(cause.effect->name), {c}, false, {StrengthRange::of(cause, isolability[c].least)}});
    if (cause.effect->id != EffectId::kLateralStressOffset) continue;
    out.push_back(out.back());
    out.back().name += kReadByAGauge, out.back().offset_read = true;
  }
  out.push_back({"unknown", {}, true, {}});
  return out;
}

/// Finds the evidence of hypotheses, one step each.
struct Search {
  const Emulator& emulator;
  const Comparison& comparison;
  const std::map<std::string, Stated>& stated;
  const MatrixXd& library;
  SmcOptions smc;
  const StepMemory* memory;
  std::map<std::string, Posterior> posteriors = {};

  /// A name of its own for each sample: "evidence: cohesion", "again: cohesion".
  void sample(const std::string& step, const Hypothesis& hypothesis, std::uint64_t stream) {
    const Likelihood likelihood(emulator, comparison, hypothesis, stated, library);
    SmcOptions own = smc;
    own.seed += stream;
    Posterior posterior = remembered_posterior(memory, step + hypothesis.name, [&] { return sample_posterior(likelihood, likelihood.parameters(), own); });
    const auto known = posteriors.find(hypothesis.name);
    if (known == posteriors.end()) posteriors.emplace(hypothesis.name, std::move(posterior));
    else known->second = together(known->second, posterior);
  }

  double log_z(const Hypothesis& hypothesis) const { return posteriors.at(hypothesis.name).log_z; }

  /// What was sampled, with its strengths. A model sampled once errs as the typical one that was sampled twice.
  std::vector<Weighed> weighed(const std::vector<Hypothesis>& hypotheses) const {
    std::vector<double> errors;
    for (const Hypothesis& h : hypotheses) {
      if (const double error = posteriors.at(h.name).log_z_error; error > 0) errors.push_back(error);
    }
    const double typical = errors.empty() ? 0 : quantile(errors, 0.5);
    std::vector<Weighed> out;
    for (const Hypothesis& h : hypotheses) {
      const Likelihood likelihood(emulator, comparison, h, stated, library);
      const Posterior& posterior = posteriors.at(h.name);
      Weighed one{.model = h.name, .cause = cause_class(h.name), .log_z = posterior.log_z, .log_z_error = posterior.log_z_error > 0 ? posterior.log_z_error : std::sqrt(2.0) * typical, .strength = {}, .draws = {}};
      for (std::size_t k = 0; k < h.causes.size(); ++k) one.strength.push_back(strength_of(emulator, h.causes[k], likelihood.strength(posterior.u, k)));
      one.draws = draws_of(likelihood, posterior.u, h.causes.size());
      one.vague = vagueness_of(likelihood, posterior.u);
      out.push_back(std::move(one));
    }
    return out;
  }
};

/// Roughly the evidence of a pair, from the posterior of one half: what the other half, anywhere in its range, makes of the likelihood.
double screened(const Search& search, const Hypothesis& half, const Hypothesis& pair, std::uint64_t stream) {
  const Posterior& posterior = search.posteriors.at(half.name);
  MatrixXd u(posterior.u.rows() + 1, kScreen);
  VectorXd before(kScreen);
  for (Index k = 0; k < kScreen; ++k) {
    const Index from = k * posterior.u.cols() / kScreen;
    u.col(k) << posterior.u.col(from), uniform(search.smc.seed, kScreenStream + stream, static_cast<std::uint64_t>(k));
    before[k] = posterior.log_likelihood[from];
  }
  return posterior.log_z + log_mean_exp(Likelihood(search.emulator, search.comparison, pair, search.stated, search.library)(u) - before);
}

/// Pairs with one of the best single effects, of two classes: those that promise most.
std::vector<Hypothesis> pairs_of(const Search& search, const std::vector<Hypothesis>& hypotheses) {
  std::vector<std::pair<double, const Hypothesis*>> best;
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    if (hypotheses[h].causes.size() == 1 && !hypotheses[h].offset_read) best.emplace_back(search.log_z(hypotheses[h]), &hypotheses[h]);
  }
  std::ranges::sort(best, std::greater{}, &std::pair<double, const Hypothesis*>::first);
  std::vector<std::pair<double, Hypothesis>> pairs;
  for (std::size_t a = 0; a < std::min(best.size(), kPartnered); ++a) {
    for (std::size_t b = 0; b < best.size(); ++b) {
      const Hypothesis &one = *best[a].second, &other = *best[b].second;
      if ((b < kPartnered && b <= a) || cause_class(one.name) == cause_class(other.name)) continue;
      Hypothesis pair{one.name + "+" + other.name, {one.causes[0], other.causes[0]}, false, {one.strength[0], other.strength[0]}};
      const double promise = screened(search, one, pair, a * best.size() + b);
      pairs.emplace_back(promise, std::move(pair));
    }
  }
  std::ranges::sort(pairs, std::greater{}, &std::pair<double, Hypothesis>::first);
  std::vector<Hypothesis> out;
  for (auto& [promise, pair] : pairs) {
    if (out.size() < kPairs) out.push_back(std::move(pair));
  }
  return out;
}

/// All hypotheses with their posteriors. An effect that takes no part, because these measurements cannot notice it, is as likely beside the
/// base model as before, with any strength.
std::vector<Believed> believed_of(const Search& search, const std::vector<Hypothesis>& hypotheses, const Diagnosis& d) {
  std::vector<Believed> out;
  const auto weighed = [&](const std::string& name) { return *std::ranges::find(d.models, name, &Weighed::model); };
  for (const Hypothesis& h : hypotheses) out.push_back({h, cause_class(h.name), weighed(h.name).probability, search.posteriors.at(h.name).u});
  std::map<std::string, int> members;
  for (const Isolability& i : d.isolability) ++members[cause_class(i.effect)];
  const auto singles = static_cast<double>(members.size());
  const Believed base = out.front();
  for (std::size_t c = 0; c < d.isolability.size(); ++c) {
    const std::string& effect = d.isolability[c].effect;
    if (d.isolability[c].seen) continue;
    MatrixXd u(base.u.rows() + 1, base.u.cols());
    u.topRows(base.u.rows()) = base.u;
    for (Index k = 0; k < u.cols(); ++k) u(u.rows() - 1, k) = uniform(search.smc.seed, kUnseenStream + c, static_cast<std::uint64_t>(k));
    const std::string cause = cause_class(effect);
    const double prior = prior_of(cause, singles) / members.at(cause) / prior_of("none", singles);
    out.push_back({{effect, {c}, false, {}}, cause, base.probability * prior, std::move(u)});
  }
  return out;
}

/// "seating, breakage": effects that take no part.
std::string unseen_of(const std::vector<Isolability>& isolability) {
  std::string out;
  for (const Isolability& i : isolability) {
    if (!i.seen) out += (out.empty() ? "" : ", ") + i.effect;
  }
  return out;
}

/// Repeats behind a typical measured feature.
int specimens_of(const Comparison& comparison) {
  std::vector<double> repeats;
  for (const Feature& f : comparison.measured) repeats.push_back(f.repeats);
  return std::max(1, static_cast<int>(quantile(repeats, 0.5)));
}

Error stopped() { return {Code::kCancelled, "stopped (the caller has gone) nothing was lost"}; }

std::vector<GroupGap> where_of(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, const DiagnosisOptions& options) {
  SmcOptions quick = options.smc;
  quick.repeats = 1, quick.particles = std::min(quick.particles, kParticlesOfWhere);
  return remembered_where(options.memory, "where", [&] { return locate(emulator, comparison, stated, quick); });
}

Error nothing_to_compare() {
  return {Code::kFailedPrecondition, "nothing to compare (no measured feature is one that the bank has) measure density, repose or stress at the bank's sigma3"};
}

}  // namespace

Result<std::vector<GroupGap>> locate(const Emulator& emulator, const ObservationSet& set, const DiagnosisOptions& options) {
  const Comparison comparison = compare(emulator, set);
  if (comparison.size() == 0) return nothing_to_compare();
  return where_of(emulator, comparison, stated_in(set, emulator.space()), options);
}

Result<Diagnosis> diagnose(const Emulator& emulator, const ObservationSet& set, const DiagnosisOptions& options, const OnStep& on_step) {
  const Comparison comparison = compare(emulator, set);
  if (comparison.size() == 0) return nothing_to_compare();
  const auto stated = stated_in(set, emulator.space());
  Diagnosis out;
  out.features = static_cast<int>(comparison.size());
  out.same_code = comparison.same_code;
  out.adequacy_threshold = options.adequacy_threshold;
  int done = 0, steps = static_cast<int>(emulator.causes().size()) + 12;
  const auto step = [&](const std::string& what) { return !on_step || on_step(what, done++, steps); };
  if (!step("what these measurements can tell apart")) return stopped();
  out.isolability = isolability(emulator, comparison, stated, options.smc.seed);
  auto hypotheses = hypotheses_of(emulator, out.isolability);
  const MatrixXd library = library_covariance(emulator, comparison, stated, options.smc.seed);
  Search search{emulator, comparison, stated, library, options.smc, options.memory};
  const auto sample_from = [&](std::size_t first) {
    for (std::size_t h = first; h < hypotheses.size(); ++h) {
      if (!step("evidence: " + hypotheses[h].name)) return false;
      search.sample("evidence: ", hypotheses[h], h + 1);
    }
    return true;
  };
  if (!sample_from(0)) return stopped();
  const std::size_t singles = hypotheses.size();
  const auto pairs = pairs_of(search, hypotheses);
  hypotheses.insert(hypotheses.end(), pairs.begin(), pairs.end());
  steps = done + static_cast<int>(pairs.size()) + 3;
  if (!sample_from(singles)) return stopped();
  if (!step("evidence again, of what comes near the best")) return stopped();
  double best = -INFINITY;
  for (const Hypothesis& h : hypotheses) best = std::max(best, search.log_z(h));
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    if (search.log_z(hypotheses[h]) > best - kNear) search.sample("again: ", hypotheses[h], kAgainStream + h);
  }
  out.models = search.weighed(hypotheses);
  weigh(out.models, options.temperature);
  const auto named = std::ranges::find_if(out.models, [](const Weighed& m) { return m.model != "unknown"; });
  const auto hypothesis = std::ranges::find(hypotheses, named->model, &Hypothesis::name);
  out.adequacy = adequacy_of(Likelihood(emulator, comparison, *hypothesis, stated, library), comparison, search.posteriors.at(named->model), options.smc.seed);
  doubt(out.models, out.adequacy);
  mistrust(out.models);
  if (!step("where")) return stopped();
  out.where = where_of(emulator, comparison, stated, options);
  if (!step("which test would tell more")) return stopped();
  const auto believed = believed_of(search, hypotheses, out);
  out.open = entropy_of_causes(believed);
  out.next = next_tests({emulator, comparison, stated, believed, specimens_of(comparison), size_ratio_of(set), options.smc.seed});
  if (const std::string unseen = unseen_of(out.isolability); !unseen.empty()) {
    out.warnings.push_back(unseen + " cannot be named: these measurements would not notice the strongest that each may be");
  }
  for (const Unused& unused : set.unused) out.warnings.push_back(unused.id + " takes no part: " + unused.why);
  decide(out);
  return out;
}

}  // namespace regolab::gap
