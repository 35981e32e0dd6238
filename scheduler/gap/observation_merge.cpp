#include "scheduler/gap/observation_merge.h"

#include <cmath>

#include "scheduler/gap/number_check.h"

namespace regolab::gap {
namespace {

constexpr double kAgree = 2;  // standard errors between repeats of one quantity that may be merged

}  // namespace

void Merger::add(Scalar scalar, Place place) {
  const auto [known, fresh] = at_.try_emplace(scalar.id, set_.scalars.size(), place);
  if (fresh) {
    set_.places[scalar.id] = place;
    set_.scalars.push_back(std::move(scalar));
    return;
  }
  Scalar& first = set_.scalars[known->second.first];
  const std::string line = std::to_string(known->second.second.line);
  const double error = std::hypot(first.standard_error, scalar.standard_error), apart = std::abs(first.value - scalar.value);
  if (apart == 0 && first.standard_error == scalar.standard_error && first.seeds == scalar.seeds) {
    warnings_.add(place, scalar.id + " stands here as in line " + line + " (value, error and repeats are the same: one measurement written twice) it counts once");
    return;
  }
  if (apart > kAgree * error) {
    report_.add(place, scalar.id + ": " + shown(scalar.value, scalar.unit) + " here, " + shown(first.value, first.unit) + " in line " + line + " (they contradict each other: " +
                           std::to_string(kAgree).substr(0, 1) + " standard errors of their difference are " + shown(kAgree * error, scalar.unit) + ") keep the right one");
    return;
  }
  const double n = first.seeds, m = scalar.seeds;
  warnings_.add(place, scalar.id + " stands here and in line " + line + " (they agree) merged into the mean of " + std::to_string(first.seeds + scalar.seeds) + " repeats");
  first.value = (n * first.value + m * scalar.value) / (n + m);
  first.standard_error = std::hypot(n * first.standard_error, m * scalar.standard_error) / (n + m);
  first.seeds += scalar.seeds;
  first.assumed |= scalar.assumed;
}

void Merger::add(MeasuredCurve curve, Place place) {
  const auto [known, fresh] = curve_at_.try_emplace(curve.id, set_.curves.size(), place);
  if (fresh) {
    set_.places[curve.id] = place;
    set_.curves.push_back(std::move(curve));
    return;
  }
  const MeasuredCurve& first = set_.curves[known->second.first];
  const std::string line = std::to_string(known->second.second.line);
  if (first.x == curve.x && first.y == curve.y && first.y_standard_error == curve.y_standard_error) {
    warnings_.add(place, curve.id + " stands here as in line " + line + " (one curve written twice) it counts once");
  } else {
    report_.add(place, curve.id + " stands here and in line " + line + " (two curves of one quantity) give their mean with its error and `seeds`");
  }
}

}  // namespace regolab::gap
