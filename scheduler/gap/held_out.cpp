#include "scheduler/gap/held_out.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "digest/sha256.h"
#include "input/number_text.h"
#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

std::string digest_of(std::span<const Feature> features) {
  std::vector<std::string> lines;  // sorted: the order in a file means nothing
  for (const Feature& f : features) {
    lines.push_back(f.id + " " + number_text(f.value) + " " + number_text(f.standard_error) + " " + std::to_string(f.repeats) + "\n");
  }
  std::ranges::sort(lines);
  Sha256 sum;
  for (const std::string& line : lines) sum.add(line);
  return sum.hex();
}

/// Bit k of the digest, whose hex digits hold four each.
bool bit(const std::string& hex, std::size_t k) {
  const char digit = hex[k / 4 % hex.size()];
  const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
  return (value >> (k % 4) & 1) != 0;
}

bool is_held(double sigma3, std::span<const double> held) {
  return std::ranges::any_of(held, [&](double one) { return std::abs(sigma3 - one) <= 1e-6 * one; });  // 2300 Pa is 2.3 kPa
}

}  // namespace

Result<std::vector<double>> held_out_sigma3(std::span<const Feature> features) {
  std::set<double> levels;
  for (const Feature& f : features) {
    if (f.group.test == Test::kStress) levels.insert(f.group.sigma3);
  }
  const std::vector<double> all(levels.begin(), levels.end());
  if (all.size() < 2) {
    return Error{Code::kFailedPrecondition, "nothing can be held out (stress tests at " + std::string(all.empty() ? "no confining stress" : "one confining stress only") +
                                                "; what confirms must not be what was fitted) measure a second one"};
  }
  const std::string digest = digest_of(features);
  std::vector<double> held;
  for (std::size_t k = 0; k + 1 < all.size(); k += 2) held.push_back(all[k + (bit(digest, k / 2) ? 1 : 0)]);
  const auto kept = std::ranges::count_if(features, [&](const Feature& f) { return f.group.test != Test::kStress || !is_held(f.group.sigma3, held); });
  if (static_cast<std::size_t>(kept) < kFewFeatures) {
    return Error{Code::kFailedPrecondition, "nothing can be held out (" + std::to_string(kept) + " features would be left to fit, " + std::to_string(kFewFeatures) +
                                                " are needed) measure more, density and repose first"};
  }
  return held;
}

ObservationSet without(ObservationSet set, std::span<const double> sigma3) {
  std::erase_if(set.scalars, [&](const Scalar& s) { return is_held(s.sigma3, sigma3); });
  std::erase_if(set.curves, [&](const MeasuredCurve& c) { return is_held(c.sigma3, sigma3); });
  return set;
}

std::string held_out_text(std::span<const double> sigma3) {
  std::string text;
  for (const double s : sigma3) text += (text.empty() ? "" : ", ") + std::string("stress ") + kilopascals(s) + " kPa";
  return text;
}

}  // namespace regolab::gap
