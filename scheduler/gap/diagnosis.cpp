#include "scheduler/gap/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scheduler/gap/draws.h"

namespace regolab::gap {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Prior probabilities; the effects share what is left, by class, so that a class with two ways to be has no more than the others.
constexpr double kPriorNone = 0.20, kPriorUnknown = 0.15;
constexpr double kSure = 0.7, kUnknownSure = 0.5, kTogether = 0.9;
constexpr double kLeastIsolability = 2, kLeastLearned = 0.3;  // [sigma], [nat]
constexpr int kReplicates = 200;

double quantile(std::vector<double> v, double share) {
  std::ranges::sort(v);
  return v[std::min(v.size() - 1, static_cast<std::size_t>(share * static_cast<double>(v.size())))];
}

Strength strength_of(const Emulator& emulator, std::size_t cause, const VectorXd& draws) {
  const EffectInfo& effect = *emulator.causes()[cause].effect;
  const std::vector<double> v(draws.data(), draws.data() + draws.size());
  return {std::string(effect.name), std::string(effect.si), quantile(v, 0.5), quantile(v, 0.05), quantile(v, 0.95)};
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

/// Share of data sets, drawn from the fitted model and its noise, that would misfit it more. Each is compared with the best of the draws.
double adequacy_of(const Likelihood& model, const Comparison& comparison, const Posterior& posterior, std::uint64_t seed) {
  const Index keep = std::min<Index>(200, posterior.u.cols());
  MatrixXd u(posterior.u.rows(), keep);
  for (Index k = 0; k < keep; ++k) u.col(k) = posterior.u.col(k * posterior.u.cols() / keep);
  const Predicted p = model.predict(u);
  const StudentT density(comparison.correlation);
  const auto misfit = [&](const VectorXd& y) {
    double least = INFINITY;
    for (Index k = 0; k < keep; ++k) least = std::min(least, density.distance2(y - p.mean.col(k), (comparison.variance + p.variance.col(k)).cwiseSqrt()));
    return least;
  };
  const double measured = misfit(comparison.y);
  const MatrixXd lower = Eigen::LLT<MatrixXd>(comparison.correlation).matrixL();
  int worse = 0;
  for (int r = 0; r < kReplicates; ++r) {
    const Index k = r % keep;
    const VectorXd sd = (comparison.variance + p.variance.col(k)).cwiseSqrt();
    worse += misfit(p.mean.col(k) + sd.asDiagonal() * (lower * normals(comparison.size(), seed, r))) >= measured ? 1 : 0;
  }
  return (worse + 1.0) / (kReplicates + 1.0);
}

std::vector<Hypothesis> hypotheses_of(const Emulator& emulator) {
  std::vector<Hypothesis> out{{"none", {}, false}};
  for (std::size_t c = 0; c < emulator.causes().size(); ++c) out.push_back({std::string(emulator.causes()[c].effect->name), {c}, false});
  out.push_back({"unknown", {}, true});
  return out;
}

/// Posterior probabilities, from log Z and the prior by class.
void weigh(std::vector<Weighed>& models, double temperature) {
  std::map<std::string, int> members;
  for (const Weighed& m : models) ++members[m.cause];
  const double effects = static_cast<double>(members.size()) - 2;
  double top = -INFINITY, sum = 0;
  for (Weighed& m : models) {
    const double prior = m.cause == "none" ? kPriorNone : m.cause == "unknown" ? kPriorUnknown : (1 - kPriorNone - kPriorUnknown) / effects / members[m.cause];
    m.probability = std::log(prior) + m.log_z / temperature;
    top = std::max(top, m.probability);
  }
  for (Weighed& m : models) sum += m.probability = std::exp(m.probability - top);
  for (Weighed& m : models) m.probability /= sum;
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

/// How far the posterior has moved from the prior [nat].
double learned(const std::vector<Weighed>& models) {
  double sum = 0;
  for (const auto& [cause, p] : by_class(models)) {
    const double prior = cause == "none" ? kPriorNone : cause == "unknown" ? kPriorUnknown : (1 - kPriorNone - kPriorUnknown) / static_cast<double>(by_class(models).size() - 2);
    if (p > 0) sum += p * std::log(p / prior);
  }
  return sum;
}

void decide(Diagnosis& d) {
  const auto classes = by_class(d.models);
  const bool isolable = std::ranges::any_of(d.isolability, [](const Isolability& i) { return i.sigma >= kLeastIsolability; });
  const auto& [best, p] = classes.front();
  d.classes.clear();
  if (!isolable || learned(d.models) < kLeastLearned) {
    d.verdict = Verdict::kCannotTell;
  } else if ((best == "unknown" && p >= kUnknownSure) || d.adequacy < d.adequacy_threshold) {
    d.verdict = Verdict::kNoneOfThese;
    d.classes = {"unknown"};
  } else if (best == "none" && p >= kSure) {
    d.verdict = Verdict::kNoGap;
    d.classes = {"none"};
  } else if (best != "none" && best != "unknown" && p >= kSure) {
    d.verdict = Verdict::kEffect;
    d.classes = {best};
  } else {
    double sum = 0;
    for (const auto& [cause, share] : classes) {
      if (sum >= kTogether) break;
      d.classes.push_back(cause), sum += share;
    }
    d.verdict = d.classes.size() > 4 ? Verdict::kCannotTell : Verdict::kOneOf;
  }
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::string_view kNames[] = {"NO GAP", "EFFECT", "ONE OF", "PAIR", "NONE OF THESE", "CANNOT TELL"};
  return kNames[static_cast<int>(verdict)];
}

std::string cause_class(const std::string& effect) {
  if (effect.starts_with("preparation_")) return "preparation";
  if (effect == "frame_compliance" || effect == "seating" || effect.starts_with("load_cell_")) return "apparatus";
  return effect;
}

namespace {

std::vector<GroupGap> where_of(const Emulator& emulator, const Comparison& comparison, const std::map<std::string, Stated>& stated, const DiagnosisOptions& options) {
  SmcOptions quick = options.smc;
  quick.repeats = 1;
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
  out.adequacy_threshold = options.adequacy_threshold;
  const auto hypotheses = hypotheses_of(emulator);
  const int steps = static_cast<int>(hypotheses.size()) + 2;
  const auto step = [&](const std::string& what, int done) { return !on_step || on_step(what, done, steps); };
  if (!step("what these measurements can tell apart", 0)) return Error{Code::kCancelled, "stopped (the caller has gone) nothing was lost"};
  out.isolability = isolability(emulator, comparison, stated, options.smc.seed);
  const MatrixXd library = library_covariance(emulator, comparison, stated, options.smc.seed);
  std::map<std::string, Posterior> posteriors;
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    const Hypothesis& hypothesis = hypotheses[h];
    if (!step("evidence: " + hypothesis.name, 1 + static_cast<int>(h))) return Error{Code::kCancelled, "stopped (the caller has gone) nothing was lost"};
    const Likelihood likelihood(emulator, comparison, hypothesis, stated, library);
    SmcOptions smc = options.smc;
    smc.seed += h + 1;
    Posterior posterior = remembered_posterior(options.memory, "evidence: " + hypothesis.name, [&] { return sample_posterior(likelihood, likelihood.parameters(), smc); });
    Weighed weighed{.model = hypothesis.name, .cause = cause_class(hypothesis.name), .log_z = posterior.log_z, .log_z_error = posterior.log_z_error, .strength = {}, .draws = {}};
    for (std::size_t k = 0; k < hypothesis.causes.size(); ++k) weighed.strength.push_back(strength_of(emulator, hypothesis.causes[k], likelihood.strength(posterior.u, k)));
    weighed.draws = draws_of(likelihood, posterior.u, hypothesis.causes.size());
    out.models.push_back(std::move(weighed));
    posteriors.emplace(hypothesis.name, std::move(posterior));
  }
  weigh(out.models, options.temperature);
  const auto named = std::ranges::find_if(out.models, [](const Weighed& m) { return m.model != "unknown"; });
  const auto hypothesis = std::ranges::find(hypotheses, named->model, &Hypothesis::name);
  out.adequacy = adequacy_of(Likelihood(emulator, comparison, *hypothesis, stated, library), comparison, posteriors.at(named->model), options.smc.seed);
  if (!step("where", steps - 1)) return Error{Code::kCancelled, "stopped (the caller has gone) nothing was lost"};
  out.where = where_of(emulator, comparison, stated, options);
  for (const Unused& unused : set.unused) out.warnings.push_back(unused.id + " takes no part: " + unused.why);
  decide(out);
  return out;
}

}  // namespace regolab::gap
