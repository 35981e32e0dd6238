#include "scheduler/gap/observation_check.h"

#include <algorithm>
#include <cmath>

#include "input/number_text.h"
#include "scheduler/gap/derived_quantities.h"
#include "scheduler/gap/number_check.h"
#include "scheduler/gap/observation_merge.h"
#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

class Checker {
 public:
  Checker(MissingErrors missing, ObservationSet& set, Report& report, Report& warnings)
      : missing_(missing), set_(set), report_(report), warnings_(warnings), number_(report), merger_(set, report, warnings) {}

  void scalar(const RawScalar& raw) {
    const auto id = scalar_id(raw.id);
    if (!id) return unused(raw.id, "unknown id (nothing is made of it) known: " + known_scalars());
    const Quantity& q = *id->quantity;
    const auto scale = number_.scale_of(raw.unit, raw.unit_place, q.si, q.what, raw.id, raw.value.written);
    const auto value = number_.checked(raw.value, scale, q, id->normal);
    const auto error = number_.error_of(raw.standard_error, scale, id->normal);
    if (!q.unused.empty()) return unused(id->normal, std::string(q.unused));
    const bool stands_in = !raw.standard_error;
    if (stands_in && missing_ == MissingErrors::kRefuse) return no_error(raw.place, id->normal);
    if (!value || (!stands_in && !error)) return;
    Scalar out{.id = id->normal, .value = *value, .unit = std::string(q.si), .unit_as_read = raw.unit, .standard_error = error.value_or(0), .assumed = stands_in,
               .seeds = raw.seeds, .definition = clean(raw.definition), .sigma3 = id->sigma3};
    if (stands_in) out.standard_error = stand_in(q, *value);
    if (out.standard_error == 0 && q.stem != "repose_column_stood") {
      warnings_.add(raw.standard_error->place, id->normal + ": a standard error of 0 (nothing is measured exactly) take it for rounded, and give more digits");
    }
    merger_.add(std::move(out), raw.id_place);
  }

  void curve(const RawCurve& raw) {
    const auto id = id_of(raw);
    if (!id) return;
    const Quantity& q = *id->quantity;
    const auto x_scale = number_.scale_of(raw.x_unit, raw.x_unit_place, curve_x_unit(q), curve_x_unit(q) == "1" ? "strain" : "length", raw.id + ".x", "x");
    const auto y_scale = number_.scale_of(raw.y_unit, raw.y_unit_place, q.si, q.what, raw.id + ".y", "y");
    const bool stands_in = !raw.y_standard_error;
    if (stands_in && missing_ == MissingErrors::kRefuse) no_error(raw.place, id->normal);
    const auto before = report_.size();
    MeasuredCurve out{.id = id->normal, .test = raw.test.empty() ? test_of(q) : clean(raw.test), .sigma3 = id->sigma3, .x_name = clean(raw.x_name), .x_unit = std::string(curve_x_unit(q)),
                      .y_name = clean(raw.y_name), .y_unit = std::string(q.si), .x_unit_as_read = raw.x_unit, .y_unit_as_read = raw.y_unit,
                      .x = {}, .y = {}, .y_standard_error = {}, .assumed = stands_in, .seeds = raw.seeds};
    lengths(raw, id->normal);
    if (!x_scale || !y_scale) return;
    ascend(raw, *x_scale, q, id->normal, out.x);
    values(raw.y, *y_scale, q, id->normal + ".y", out.y);
    if (!stands_in) errors(*raw.y_standard_error, y_scale->factor, id->normal, out.y_standard_error);
    if (report_.size() != before || (stands_in && missing_ == MissingErrors::kRefuse)) return;
    if (stands_in) {
      double size = 0;
      for (const double y : out.y) size = std::max(size, std::abs(y));
      for (const double y : out.y) out.y_standard_error.push_back(std::max(stand_in(q, y), 0.1 * stand_in(q, size)));
    }
    merger_.add(std::move(out), raw.id_place);
  }

  void finish() {
    resolve_derived(set_, merger_, warnings_);
    for (const Scalar& s : set_.scalars) set_.assumed |= s.assumed;
    for (const MeasuredCurve& c : set_.curves) set_.assumed |= c.assumed;
  }

 private:
  void unused(const std::string& id, const std::string& why) { set_.unused.push_back({excerpt(id), why}); }

  void no_error(Place place, const std::string& id) {
    report_.add(place, id + " has no standard error (without one nobody can tell a gap from scatter) give `standard_error` of the mean, or pass --assume-errors for a stated default");
  }

  static double stand_in(const Quantity& q, double value) { return q.assumed_relative * std::abs(value) + q.assumed_absolute; }

  static std::string test_of(const Quantity& q) {
    return q.tail == Quantity::Tail::kNone ? "repose" : q.tail == Quantity::Tail::kPlate ? "penetration" : "stress";
  }

  std::optional<ObservableId> id_of(const RawCurve& raw) {
    auto id = curve_id(raw.id);
    if (!id && raw.sigma3) id = curve_id(raw.id, raw.sigma3->value);
    if (!id) {
      unused(raw.id, "unknown curve (nothing is made of it) known: " + known_curves());
      return std::nullopt;
    }
    if (raw.sigma3 && id->sigma3 > 0 && std::abs(raw.sigma3->value / id->sigma3 - 1) > 1e-6) {
      report_.add(raw.sigma3->place, raw.id + ": sigma3 is " + excerpt(raw.sigma3->written) + " here and " + shown(id->sigma3, "Pa") + " in the id (one of them is wrong) correct it");
      return std::nullopt;
    }
    return id;
  }

  void lengths(const RawCurve& raw, const std::string& id) {
    const std::size_t n = raw.x.numbers.size();
    const auto differs = [&](const RawList& list, const std::string& name) {
      if (list.numbers.size() == n) return;
      report_.add(list.place, id + ": " + std::to_string(list.numbers.size()) + " entries of " + name + " for " + std::to_string(n) + " of x (each point has both) the list may be cut off");
    };
    if (n < 2) report_.add(raw.x.place, id + ": " + std::to_string(n) + " points (a curve has two or more) give single numbers under `observables`");
    differs(raw.y, "y");
    if (raw.y_standard_error) differs(*raw.y_standard_error, "y_standard_error");
  }

  void ascend(const RawCurve& raw, const Scale& scale, const Quantity& q, const std::string& id, std::vector<double>& x) {
    const bool strain = curve_x_unit(q) == "1";
    for (const RawNumber& number : raw.x.numbers) {
      if (!number_.finite(number, id + ".x")) return;
      const double si = scale(number.value);
      if (strain && si > 1) {
        report_.add(number.place, id + ".x: an axial strain of " + excerpt(number.written) + " (nothing is compressed by more than all of its length) if it is per cent, write `x_unit: '%'`");
        return;
      }
      if (!x.empty() && !(si > x.back())) {
        report_.add(number.place, id + ".x: " + excerpt(number.written) + " does not lie beyond the point before (x must ascend) sort the points, and leave unloading out");
        return;
      }
      x.push_back(si);
    }
  }

  void values(const RawList& list, const Scale& scale, const Quantity& q, const std::string& path, std::vector<double>& out) {
    for (const RawNumber& number : list.numbers) {
      const auto value = number_.checked(number, scale, q, path);
      if (!value) return;  // one message a list
      out.push_back(*value);
    }
  }

  void errors(const RawList& list, double factor, const std::string& id, std::vector<double>& out) {
    for (const RawNumber& number : list.numbers) {
      if (!number_.is_error(number, id + ".y")) return;
      out.push_back(std::abs(factor) * number.value);
    }
  }

  const MissingErrors missing_;
  ObservationSet& set_;
  Report& report_;
  Report& warnings_;
  NumberCheck number_;
  Merger merger_;
};

}  // namespace

void check_observations(const RawObservations& raw, MissingErrors missing, ObservationSet& set, Report& report, Report& warnings) {
  Checker checker(missing, set, report, warnings);
  for (const RawScalar& scalar : raw.scalars) checker.scalar(scalar);
  for (const RawCurve& curve : raw.curves) checker.curve(curve);
  checker.finish();
}

}  // namespace regolab::gap
