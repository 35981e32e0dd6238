#include "scheduler/gap/blind/score.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace regolab::gap {
namespace {

using Marks = std::vector<const Mark*>;
constexpr double kStrong = 4;  // [sigma] isolability from which a miss has no excuse

Marks those(const std::vector<Mark>& marks, const std::function<bool(const Mark&)>& wanted) {
  Marks out;
  for (const Mark& m : marks) {
    if (wanted(m)) out.push_back(&m);
  }
  return out;
}

bool is(const Mark& m, TruthKind kind) { return m.truth.kind == kind; }
bool main_case(const Mark& m) { return !m.truth.extra; }
bool unknown_named(const Mark& m) { return m.ours.named == "unknown"; }
/// Anything but "nothing is wrong" or "I cannot tell", said of a case where nothing is wrong. ONE OF speaks by its most probable member.
bool alarm(const Mark& m) { return m.ours.named != "none" && !m.ours.named.empty(); }
bool lists(const Mark& m, const std::string& cause) { return std::ranges::find(m.listed, cause) != m.listed.end(); }
bool leaves_none_out(const Mark& m) { return !m.listed.empty() && !lists(m, "none"); }
/// The truth, of a pair both halves, is what the verdict names or among it.
bool truth_listed(const Mark& m) {
  const auto plus = m.answer.find('+');
  return lists(m, m.answer) || (plus != std::string::npos && lists(m, m.answer.substr(0, plus)) && lists(m, m.answer.substr(plus + 1)));
}

Interval share(const Marks& marks, const std::function<bool(const Mark&)>& hit) {
  return share_of(static_cast<int>(std::ranges::count_if(marks, [&](const Mark* m) { return hit(*m); })), static_cast<int>(marks.size()));
}

Interval over(const Marks& marks, const std::function<double(const Mark&)>& value, double (*figure)(const std::vector<double>&)) {
  return bootstrap(static_cast<int>(marks.size()), [&](const std::vector<int>& cases) {
    std::vector<double> v;
    for (const int k : cases) v.push_back(value(*marks[static_cast<std::size_t>(k)]));
    return figure(v);
  });
}
double middle(const std::vector<double>& v) { return median(v); }

/// One confidence for all cases, chosen in hindsight; see score_of.
void give_confidence(std::vector<Mark>& marks, const std::string& baseline) {
  int hits = 0, n = 0;
  for (const Mark& m : marks) {
    if (main_case(m)) ++n, hits += m.baselines.at(baseline).named == m.answer;
  }
  const double others = static_cast<double>(all_answers().size()) - 1,
               sure = n == 0 ? 0.5 : std::max(1 / (others + 1), static_cast<double>(hits) / n);
  for (Mark& m : marks) {
    std::map<std::string, double> p;
    const std::string named = m.baselines.at(baseline).named;
    for (const std::string& answer : all_answers()) p[answer] = answer == named ? sure : (1 - sure) / others;
    m.baselines[baseline] = doubting(named, p);
  }
}

void add_commonest(std::vector<Mark>& marks) {
  std::map<std::string, double> counts;
  for (const Mark& m : marks) {
    if (main_case(m)) counts[m.answer] += 1;
  }
  if (counts.empty()) return;
  const auto most = std::ranges::max_element(counts, {}, [](const auto& item) { return item.second; });
  for (Mark& m : marks) m.baselines["commonest"] = doubting(most->first, counts);
}

MethodScore method(const Marks& marks, const std::string& name, const std::function<const Opinion&(const Mark&)>& opinion,
                   const std::function<bool(const Mark&)>& right) {
  MethodScore out{.name = name};
  out.top1 = share(marks, right);
  out.log_score = over(
      marks, [&](const Mark& m) { return log_score(opinion(m), m.answer); }, &mean);
  out.brier = over(
      marks, [&](const Mark& m) { return brier(opinion(m), m.answer); }, &mean);
  out.log_score_less_ours = over(
      marks, [&](const Mark& m) { return log_score(opinion(m), m.answer) - log_score(m.ours, m.answer); }, &mean);
  out.brier_less_ours = over(
      marks, [&](const Mark& m) { return brier(opinion(m), m.answer) - brier(m.ours, m.answer); }, &mean);
  return out;
}

Interval calibration(const Marks& marks) {
  std::vector<double> confidence;
  std::vector<bool> right;
  for (const Mark* m : marks) {
    confidence.push_back(m->declared_confidence);
    const auto top = std::ranges::max_element(m->ours.p, {}, [](const auto& item) { return item.second; });
    right.push_back(top->first == m->answer);
  }
  return bootstrap(static_cast<int>(marks.size()), [&](const std::vector<int>& cases) { return calibration_error(confidence, right, cases); });
}

Interval calibration_floor_of(const Marks& marks) {
  std::vector<double> confidence;
  for (const Mark* m : marks) confidence.push_back(m->declared_confidence);
  const CalibrationFloor floor = calibration_floor(confidence);
  return {floor.mean, 0, floor.q95, static_cast<int>(marks.size())};
}

std::vector<Figure> figures_of(const std::vector<Mark>& marks) {
  const Marks all = those(marks, &main_case), nulls = those(marks, [](const Mark&m) { return is(m, TruthKind::kNull); }),
              extra = those(marks, [](const Mark&m) { return m.truth.extra; });
  const Marks unknown = those(marks, [](const Mark&m) { return is(m, TruthKind::kUnknown); }),
              known = those(marks, [](const Mark&m) { return main_case(m) && !is(m, TruthKind::kUnknown); });
  const Marks strong = those(marks, [](const Mark& m) { return m.gap && m.gap->isolability > kStrong; });
  const Marks weak = those(marks, [](const Mark& m) { return m.gap && m.gap->isolability <= kStrong; });
  const Marks sized = those(marks, [](const Mark& m) { return m.strength.has_value(); });
  const Marks sized_named = those(marks, [](const Mark& m) { return m.strength.has_value() && m.ours.named == m.answer; });
  const Marks placed = those(marks, [](const Mark&m) { return m.where.has_value(); }),
              placed_strong = those(marks, [](const Mark&m) { return m.where.has_value() && m.gap->isolability > kStrong; });
  const Marks shrunk = those(marks, [](const Mark& m) { return m.shrinkage.has_value(); });
  const auto right = [](const Mark& m) { return m.right; };
  const auto strictly = [](const Mark& m) { return m.strictly_right; };
  const auto error = [](const Mark& m) { return std::min(m.strength->log_error(), 10.0); };  // a wrong sign counts as far off, not as no number
  const auto covered = [](const Mark& m) { return m.strength->covered(); };
  return {
      {"top1", "right, main cases", ">= 0.85", share(all, right)},
      {"top1_strict", "the same, CANNOT TELL never right", "", share(all, strictly)},
      {"listed", "named or in ONE OF, main cases", "", share(all, &truth_listed)},
      {"top1_strong", "right, isolability above 4", ">= 0.95", share(strong, right)},
      {"top1_weak", "right, isolability up to 4", "", share(weak, right)},
      {"log_score", "mean -ln P(right), main cases", "below every baseline",
       over(
           all, [](const Mark& m) { return log_score(m.ours, m.answer); }, &mean)},
      {"brier", "multi-class Brier score, main cases", "below every baseline",
       over(
           all, [](const Mark& m) { return brier(m.ours, m.answer); }, &mean)},
      {"calibration_error", "expected, 5 bins of equal numbers, main cases", "within the floor", calibration(all)},
      {"calibration_floor", "of a perfectly calibrated judge (95 % quantile as the upper end)", "", calibration_floor_of(all)},
      {"false_alarms_extra", "a gap named in extra nulls", "<= 1 of 60", share(extra, &alarm)},
      {"false_alarms", "a gap named in all nulls", "", share(nulls, &alarm)},
      {"false_alarms_sure", "a verdict that leaves no gap out, all nulls", "", share(nulls, &leaves_none_out)},
      {"unknown_detected", "NONE OF THESE in unknowns", ">= 0.80", share(unknown, &unknown_named)},
      {"false_none_of_these", "NONE OF THESE in main cases that are no unknowns", "<= 0.05", share(known, &unknown_named)},
      {"strength_log_error", "median |ln(estimate/truth)|, single effects named rightly", "<= 0.15", over(sized_named, error, &middle)},
      {"strength_coverage", "truth inside the 90 % interval, single effects named rightly", "0.84 to 0.96", share(sized_named, covered)},
      {"strength_log_error_all", "the same error, all single effects", "", over(sized, error, &middle)},
      {"strength_coverage_all", "the same share, all single effects", "", share(sized, covered)},
      {"where", "truly moved group first", ">= 0.85", share(placed, [](const Mark& m) { return *m.where; })},
      {"where_strong", "the same, isolability above 4", "", share(placed_strong, [](const Mark& m) { return *m.where; })},
      {"shrinkage", "median S, measured by new runs", ">= 0.7",
       over(
           shrunk, [](const Mark& m) { return m.shrinkage->s; }, &middle)},
  };
}

}  // namespace

double log_score(const Opinion& opinion, const std::string& answer) { return -std::log(opinion.p.at(answer)); }

double brier(const Opinion& opinion, const std::string& answer) {
  double sum = 0;
  for (const auto& [name, p] : opinion.p) sum += (p - (name == answer ? 1 : 0)) * (p - (name == answer ? 1 : 0));
  return sum;
}

Score score_of(std::vector<Mark>& marks, int missing) {
  give_confidence(marks, "lowest_rms"), give_confidence(marks, "nearest_pattern");
  add_commonest(marks);
  Score out{.missing = missing};
  out.development = std::ranges::any_of(marks, [](const Mark& m) { return m.truth.development; });
  out.extra = static_cast<int>(std::ranges::count_if(marks, [](const Mark& m) { return m.truth.extra; }));
  out.cases = static_cast<int>(marks.size()) - out.extra;
  out.figures = figures_of(marks);
  const Marks all = those(marks, &main_case);
  out.methods.push_back(method(
      all, "ours", [](const Mark& m) -> const Opinion& { return m.ours; }, [](const Mark& m) { return m.strictly_right; }));
  for (const char* name : {"lowest_rms", "bic", "nearest_pattern", "commonest"}) {
    if (all.empty()) break;
    out.methods.push_back(method(
        all, name, [&](const Mark& m) -> const Opinion& { return m.baselines.at(name); },
        [&](const Mark& m) { return m.baselines.at(name).named == m.answer; }));
  }
  for (const Mark* m : all) {
    auto& group = is(*m, TruthKind::kUnknown) ? out.unknowns : out.effects;
    const std::string& key = is(*m, TruthKind::kUnknown) ? m->truth.unknown : is(*m, TruthKind::kPair) ? "pair" : m->answer;
    if (group.contains(key)) continue;
    group[key] = share(those(marks,
                             [&](const Mark& o) {
                               return main_case(o) && o.truth.kind == m->truth.kind && o.truth.unknown == m->truth.unknown &&
                                      (is(o, TruthKind::kPair) || o.answer == m->answer);
                             }),
                       [](const Mark& o) { return o.right; });
  }
  return out;
}

}  // namespace regolab::gap
