#include "scheduler/surrogate/invert.h"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "scheduler/surrogate/material.h"
#include "vocab/units.h"

namespace regolab::surrogate {
namespace {

constexpr int kSpread = 2048;         // materials over the box
constexpr std::size_t kStarts = 3;    // of the optimiser, per combination of choices
constexpr int kStartsTried = 96;

/// Halton sequence: share j of point k.
double halton(int k, std::size_t j) {
  constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  const int base = kPrimes[j % std::size(kPrimes)];
  double share = 0, weight = 1;
  for (int i = k + 20; i > 0; i /= base) share += (weight /= base) * (i % base);
  return share;
}

struct Search {
  const Model& model;
  const Question& question;
  std::vector<std::size_t> numbers;  ///< columns that vary as numbers

  std::vector<Estimate> estimates(const std::vector<double>& x) const {
    std::vector<Estimate> out;
    const Inputs inputs = inputs_of(model.data.columns, x);
    for (const Target& target : question.targets) {
      out.push_back(target.sigma3 > 0 ? *model.sigma1_at(x, target.sigma3) : model.predict_one(*model.find(target.response), inputs));
    }
    return out;
  }

  /// Expected squared miss in tolerances: off the target, or not known to be on it.
  double cost(const std::vector<Estimate>& e) const {
    double sum = 0;
    for (std::size_t t = 0; t < e.size(); ++t) {
      const double spread = (e[t].mean_high - e[t].mean_low) / (2 * kNormal90), off = e[t].value - question.targets[t].value;
      sum += (off * off + 0.25 * spread * spread) / (question.targets[t].tolerance * question.targets[t].tolerance);
    }
    return sum;
  }

  std::vector<double> at(int k, const std::vector<double>& choices) const {
    std::vector<double> x = choices;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const auto& span = question.spans[numbers[n]];
      x[numbers[n]] = span.low + (span.high - span.low) * halton(k, n);
    }
    return x;
  }
};

double objective(const std::vector<double>& u, std::vector<double>&, void* data) {
  const auto& [search, x] = *static_cast<std::pair<const Search*, std::vector<double>*>*>(data);
  for (std::size_t n = 0; n < u.size(); ++n) {
    const auto& span = search->question.spans[search->numbers[n]];
    (*x)[search->numbers[n]] = span.low + (span.high - span.low) * u[n];
  }
  return search->cost(search->estimates(*x));
}

std::vector<double> descend(const Search& search, std::vector<double> x) {
  if (search.numbers.empty()) return x;
  nlopt::opt optimiser(nlopt::LN_BOBYQA, static_cast<unsigned>(search.numbers.size()));
  std::pair<const Search*, std::vector<double>*> data{&search, &x};
  optimiser.set_min_objective(objective, &data);
  optimiser.set_lower_bounds(0.0);
  optimiser.set_upper_bounds(1.0);
  optimiser.set_initial_step(0.1);
  optimiser.set_xtol_abs(1e-3);
  optimiser.set_maxeval(250);
  std::vector<double> u;
  for (const std::size_t c : search.numbers) {
    const auto& span = search.question.spans[c];
    u.push_back((x[c] - span.low) / (span.high - span.low));
  }
  double value = 0;
  try {
    optimiser.optimize(u, value);
  } catch (const std::runtime_error&) {  // stopped by round-off: where it stands is an answer
  }
  std::vector<double> gradient;
  objective(u, gradient, &data);
  return x;
}

/// Four digits are what a person would write, and far below what a tolerance feels.
void round_to_four_digits(const Model& model, std::vector<double>& x) {
  for (std::size_t c = 0; c < x.size(); ++c) {
    const InputColumn& column = model.data.columns[c];
    if (column.is_choice() || x[c] == 0 || column.low == column.high) continue;
    const double factor = input_factor(column), shown = x[c] * factor;
    const double unit = std::pow(10, 3 - std::floor(std::log10(std::abs(shown))));
    x[c] = std::clamp(std::round(shown * unit) / unit / factor, column.low, column.high);
  }
}

double normal_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

Candidate candidate_of(const Search& search, std::vector<double> x) {
  round_to_four_digits(search.model, x);
  Candidate out{.x = std::move(x), .estimates = {}, .probability = 1};
  out.estimates = search.estimates(out.x);
  for (std::size_t t = 0; t < out.estimates.size(); ++t) {
    const Target& target = search.question.targets[t];
    const Estimate& e = out.estimates[t];
    const double spread = std::max(1e-300, (e.mean_high - e.mean_low) / (2 * kNormal90));
    out.probability *= normal_below((target.value + target.tolerance - e.value) / spread) - normal_below((target.value - target.tolerance - e.value) / spread);
    out.miss = std::max(out.miss, std::abs(e.value - target.value) / target.tolerance);
  }
  return out;
}

/// All combinations of the open choices; numbers stand at their lows.
std::vector<std::vector<double>> combinations(const Question& question) {
  std::vector<std::vector<double>> out{std::vector<double>(question.spans.size(), 0.0)};
  for (std::size_t c = 0; c < question.spans.size(); ++c) {
    const auto& span = question.spans[c];
    std::vector<std::vector<double>> next;
    for (auto& x : out) {
      for (const double value : span.choices.empty() ? std::vector<double>{span.low} : span.choices) {
        x[c] = value;
        next.push_back(x);
      }
    }
    out = std::move(next);
  }
  return out;
}

struct Reach {
  double low = INFINITY, high = -INFINITY;
};

/// Tries materials all over the box: which may fit, what they span, how far each property reaches.
void look_around(const Search& search, const std::vector<std::vector<double>>& choices, Inversion& out) {
  std::vector<Reach> reach(search.question.targets.size());
  std::vector<std::vector<double>> fits;
  for (out.tried = 0; out.tried < kSpread; ++out.tried) {
    const auto x = search.at(out.tried, choices[static_cast<std::size_t>(out.tried) % choices.size()]);
    const auto estimates = search.estimates(x);
    bool fit = true;
    for (std::size_t t = 0; t < estimates.size(); ++t) {
      const Target& target = search.question.targets[t];
      reach[t].low = std::min(reach[t].low, estimates[t].value);
      reach[t].high = std::max(reach[t].high, estimates[t].value);
      fit = fit && estimates[t].mean_low <= target.value + target.tolerance && estimates[t].mean_high >= target.value - target.tolerance;
    }
    if (fit) fits.push_back(x);
  }
  out.fitting = static_cast<int>(fits.size());
  out.freedom = search.question.spans;
  for (std::size_t c = 0; c < out.freedom.size() && !fits.empty(); ++c) {
    auto& span = out.freedom[c];
    const auto [low, high] = std::ranges::minmax(fits, {}, [c](const auto& x) { return x[c]; });
    if (span.choices.empty()) span.low = low[c], span.high = high[c];
    else std::erase_if(span.choices, [&](double value) { return std::ranges::none_of(fits, [&](const auto& x) { return x[c] == value; }); });
  }
  for (std::size_t t = 0; t < reach.size(); ++t) {
    const Target& target = search.question.targets[t];
    if (target.value + target.tolerance >= reach[t].low && target.value - target.tolerance <= reach[t].high) continue;
    const DoorUnit door = door_unit(target.unit);
    char text[200];
    std::snprintf(text, sizeof text, "%s %.4g %s is out of reach (materials of the box give %.4g to %.4g by the model) choose a target inside, or free more parameters",
                  target.response.c_str(), target.value * door.factor, std::string(door.name).c_str(), reach[t].low * door.factor, reach[t].high * door.factor);
    out.notes.emplace_back(text);
  }
}

}  // namespace

Inversion invert(const Model& model, const Question& question, std::size_t wanted) {
  Search search{model, question, {}};
  for (std::size_t c = 0; c < question.spans.size(); ++c) {
    if (question.spans[c].choices.empty() && question.spans[c].high > question.spans[c].low) search.numbers.push_back(c);
  }
  const auto choices = combinations(question);
  Inversion out;
  look_around(search, choices, out);
  std::vector<std::vector<Candidate>> rounds(kStarts);  // the best of each combination, then the second best, ...
  for (const auto& combination : choices) {
    std::vector<std::pair<double, std::vector<double>>> starts;
    for (int k = 0; k < kStartsTried; ++k) {
      auto x = search.at(k, combination);
      starts.emplace_back(search.cost(search.estimates(x)), std::move(x));
    }
    std::ranges::sort(starts, {}, &std::pair<double, std::vector<double>>::first);
    std::vector<Candidate> own;
    for (std::size_t s = 0; s < kStarts; ++s) own.push_back(candidate_of(search, descend(search, starts[s].second)));
    std::ranges::sort(own, std::greater{}, &Candidate::probability);
    for (std::size_t s = 0; s < kStarts; ++s) rounds[s].push_back(std::move(own[s]));
  }
  for (auto& round : rounds) {
    std::ranges::sort(round, std::greater{}, &Candidate::probability);
    for (Candidate& candidate : round) {
      if (out.candidates.size() < wanted) out.candidates.push_back(std::move(candidate));
    }
  }
  if (out.notes.empty() && out.candidates.front().miss > 1) {
    char text[200];
    std::snprintf(text, sizeof text, "no material of the box meets all targets together by the model (the nearest misses by %.1f tolerances) widen a tolerance or free more parameters",
                  out.candidates.front().miss);
    out.notes.emplace_back(text);
  }
  return out;
}

}  // namespace regolab::surrogate
