#include "scheduler/gap/blind/marks.h"

#include <algorithm>
#include <cmath>

#include "scheduler/gap/blind/draw.h"
#include "scheduler/gap/verdict.h"

namespace regolab::gap {
namespace {

constexpr double kIdentifiable = 2;  // [sigma] isolability, design section 2.5

/// What the verdict names: "" of CANNOT TELL.
std::string named_by(const Diagnosis& d) {
  switch (d.verdict) {
    case Verdict::kNoGap: return "none";
    case Verdict::kNoneOfThese: return "unknown";
    case Verdict::kCannotTell: return "";
    case Verdict::kPair: return d.classes.size() == 2 ? cause_class(d.classes[0] + "+" + d.classes[1]) : "";
    default: return d.classes.empty() ? "" : d.classes.front();
  }
}

std::map<std::string, double> probabilities(const Diagnosis& d) {
  const auto classes = by_class(d.models);
  return {classes.begin(), classes.end()};
}

std::optional<StrengthMark> strength_mark(const Truth& truth, const Diagnosis& d) {
  if (truth.kind != TruthKind::kEffect) return std::nullopt;
  const auto& [effect, strength] = *truth.effects.begin();
  const auto model = std::ranges::find(d.models, effect, &Weighed::model);
  if (model == d.models.end() || model->strength.empty()) return std::nullopt;
  const Strength& s = model->strength.front();
  return StrengthMark{effect, s.unit, strength, s.median, s.low, s.high};
}

}  // namespace

const std::vector<std::string>& all_answers() {
  static const auto all = [] {
    std::vector<std::string> classes, out{"none", "unknown"};
    for (const CauseMembers& cause : all_causes()) classes.push_back(cause.cause);
    std::ranges::sort(classes);
    out.insert(out.end(), classes.begin(), classes.end());
    for (std::size_t a = 0; a < classes.size(); ++a) {
      for (std::size_t b = a + 1; b < classes.size(); ++b) out.push_back(classes[a] + "+" + classes[b]);
    }
    return out;
  }();
  return all;
}

Opinion doubting(std::string named, const std::map<std::string, double>& p) {
  Opinion out{std::move(named), {}};
  const double share = 1 / static_cast<double>(all_answers().size());
  double sum = 0;
  for (const std::string& answer : all_answers()) {
    const auto known = p.find(answer);
    sum += known == p.end() ? 0 : known->second;
  }
  for (const std::string& answer : all_answers()) {
    const auto known = p.find(answer);
    const double own = sum > 0 ? (known == p.end() ? 0 : known->second / sum) : share;  // no opinion at all: evenly
    out.p[answer] = (1 - kDoubt) * own + kDoubt * share;
  }
  return out;
}

double StrengthMark::log_error() const {
  if (!(median * truth > 0)) return INFINITY;
  return std::abs(std::log(median / truth));
}

Mark mark_of(const Truth& truth, const Answer& answer, const std::optional<TrueGap>& gap, const std::optional<MeasuredShrinkage>& shrinkage) {
  const Diagnosis& d = answer.diagnosis;
  Mark out{.truth = truth,
           .answer = answer_of(truth),
           .verdict = std::string(name_of(d.verdict)),
           .ours = doubting(named_by(d), probabilities(d)),
           .listed = d.verdict == Verdict::kCannotTell ? std::vector<std::string>{} : d.classes,
           .gap = gap,
           .strength = strength_mark(truth, d),
           .shrinkage = shrinkage,
           .baselines = {},
           .problem = answer.problem,
           .protection = answer.source.protection,
           .adequacy = d.adequacy};
  for (const auto& [name, p] : out.ours.p) out.declared_confidence = std::max(out.declared_confidence, p);
  out.strictly_right = out.ours.named == out.answer;
  out.right = out.strictly_right || (d.verdict == Verdict::kCannotTell && gap && gap->isolability < kIdentifiable);
  if (gap && !answer.where.empty()) out.where = answer.where == gap->moved;
  std::map<std::string, double> bic;
  for (const Refit& r : answer.baselines.refits) bic[cause_class(r.model)] += r.bic_probability;
  out.baselines["bic"] = doubting(cause_class(answer.baselines.bic), bic);
  out.baselines["lowest_rms"] = {cause_class(answer.baselines.lowest_rms), {}};
  out.baselines["nearest_pattern"] = {cause_class(answer.baselines.nearest_pattern), {}};
  return out;
}

}  // namespace regolab::gap
