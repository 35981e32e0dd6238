#include "scheduler/gap/observation_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "input/number_text.h"
#include "input/unit_convert.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

constexpr double kAgree = 2;       // standard errors between repeats of one quantity that may be merged
constexpr double kContradict = 3;  // between density and void ratio

/// "1.42 g/cm3".
std::string shown(double si, std::string_view unit) {
  const DoorUnit door = door_unit(unit);
  char digits[32];
  const int n = std::snprintf(digits, sizeof digits, "%.4g", si * door.factor);
  return std::string(digits, static_cast<std::size_t>(n)) + (unit == "1" ? "" : " " + std::string(door.name));
}

/// Free text without control bytes.
std::string clean(std::string text) {
  std::ranges::replace_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return text;
}

/// Unit conversion is linear: one look-up serves a whole curve.
struct Scale {
  double factor = 1, offset = 0;
  double operator()(double value) const { return offset + factor * value; }
};

class Checker {
 public:
  Checker(MissingErrors missing, ObservationSet& set, Report& report, Report& warnings)
      : missing_(missing), set_(set), report_(report), warnings_(warnings) {}

  void scalar(const RawScalar& raw) {
    const auto id = scalar_id(raw.id);
    if (!id) return unused(raw.id, "unknown id (nothing is made of it) known: " + known_scalars());
    const Quantity& q = *id->quantity;
    const auto scale = scale_of(raw.unit, raw.unit_place, q.si, q.what, raw.id, raw.value.written);
    const auto value = checked(raw.value, scale, q, id->normal);
    const auto error = error_of(raw.standard_error, scale, id->normal);
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
    add(std::move(out), raw.id_place);
  }

  void curve(const RawCurve& raw) {
    const auto id = id_of(raw);
    if (!id) return;
    const Quantity& q = *id->quantity;
    const auto x_scale = scale_of(raw.x_unit, raw.x_unit_place, curve_x_unit(q), curve_x_unit(q) == "1" ? "strain" : "length", raw.id + ".x", "x");
    const auto y_scale = scale_of(raw.y_unit, raw.y_unit_place, q.si, q.what, raw.id + ".y", "y");
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
    add(std::move(out), raw);
  }

  void finish() {
    resolve_density();
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

  std::optional<Scale> scale_of(const std::string& unit, Place place, std::string_view si, std::string_view what, const std::string& path, const std::string& written) {
    if (unit.empty()) {
      report_.add(place, excerpt(path) + " has no unit (numbers without one cannot be compared) write e.g. `unit: " + std::string(door_unit(si).name) + "`");
      return std::nullopt;
    }
    const std::string text = excerpt(written) + " " + unit;
    const auto zero = convert_to_si(0, text, unit, si, what), one = convert_to_si(1, text, unit, si, what);
    if (zero.ok() && one.ok()) return Scale{*one - *zero, *zero};
    report_.add(place, excerpt(path) + ": " + (zero.ok() ? one.error().text : zero.error().text));
    return std::nullopt;
  }

  bool finite(const RawNumber& number, const std::string& path) {
    if (std::isfinite(number.value)) return true;
    report_.add(number.place, path + ": '" + excerpt(number.written) + "' is not a finite number (nothing can be compared with it) correct it, or leave the entry out");
    return false;
  }

  bool in_range(double si, const RawNumber& number, const Quantity& q, const std::string& path) {
    if (std::isfinite(si) && (si > q.low || (q.low_too && si == q.low)) && si <= q.high * (1 + 1e-9)) return true;
    report_.add(number.place, path + ": " + excerpt(number.written) + " (a " + std::string(q.what) + (q.low_too ? " from " : " above ") + shown(q.low, q.si) + " to " +
                                  shown(q.high, q.si) + " can be measured) check value and unit");
    return false;
  }

  std::optional<double> checked(const RawNumber& number, const std::optional<Scale>& scale, const Quantity& q, const std::string& path) {
    if (!finite(number, path) || !scale) return std::nullopt;
    const double si = (*scale)(number.value);
    return in_range(si, number, q, path) ? std::optional(si) : std::nullopt;
  }

  bool is_error(const RawNumber& number, const std::string& path) {
    if (!finite(number, path + ".standard_error")) return false;
    if (number.value >= 0) return true;
    report_.add(number.place, path + ": a standard error of " + excerpt(number.written) + " (must not be negative) give its size");
    return false;
  }

  std::optional<double> error_of(const std::optional<RawNumber>& number, const std::optional<Scale>& scale, const std::string& path) {
    if (!number || !is_error(*number, path) || !scale) return std::nullopt;
    return std::abs(scale->factor) * number->value;
  }

  /// Repeats of one quantity: the same line twice counts once, what agrees is merged by the number of repeats, all else is refused.
  void add(Scalar scalar, Place place) {
    const auto [known, fresh] = at_.try_emplace(scalar.id, set_.scalars.size(), place);
    if (fresh) {
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

  void add(MeasuredCurve curve, const RawCurve& raw) {
    const auto [known, fresh] = curve_at_.try_emplace(curve.id, set_.curves.size(), raw.id_place);
    if (fresh) {
      set_.curves.push_back(std::move(curve));
      return;
    }
    const MeasuredCurve& first = set_.curves[known->second.first];
    const std::string line = std::to_string(known->second.second.line);
    if (first.x == curve.x && first.y == curve.y && first.y_standard_error == curve.y_standard_error) {
      warnings_.add(raw.id_place, curve.id + " stands here as in line " + line + " (one curve written twice) it counts once");
    } else {
      report_.add(raw.id_place, curve.id + " stands here and in line " + line + " (two curves of one quantity) give their mean with its error and `seeds`");
    }
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
      if (!finite(number, id + ".x")) return;
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
      const auto value = checked(number, scale, q, path);
      if (!value) return;  // one message a list
      out.push_back(*value);
    }
  }

  void errors(const RawList& list, double factor, const std::string& id, std::vector<double>& out) {
    for (const RawNumber& number : list.numbers) {
      if (!is_error(number, id + ".y")) return;
      out.push_back(std::abs(factor) * number.value);
    }
  }

  /// Density and void ratio are one measurement: with the grain density known, the density stays.
  void resolve_density() {
    const auto e = std::ranges::find(set_.scalars, "void_ratio", &Scalar::id);
    if (e == set_.scalars.end()) return;
    const auto rho = std::ranges::find(set_.scalars, "bulk_density", &Scalar::id);
    const auto& grain = set_.material.grain_density;
    if (rho != set_.scalars.end()) {
      if (grain) compare(*rho, *e, *grain);
      unused("void_ratio", grain ? "derived (bulk_density and the grain density say the same) the density is kept"
                                 : "one measurement with bulk_density (they would count twice) the density is kept");
      set_.scalars.erase(e);
      return;
    }
    if (!grain) {
      unused("void_ratio", "no grain density (only with it is a void ratio a density) give material.particle_density_g_cm3");
      set_.scalars.erase(e);
      return;
    }
    const double density = grain->value / (1 + e->value);
    const double error = density * std::hypot(e->standard_error / (1 + e->value), grain->standard_error.value_or(0) / grain->value);
    warnings_.add(at_.at("void_ratio").second, "void_ratio is used as the bulk density it means (" + shown(density, "kg/m3") + " with the grain density given)");
    *e = {.id = "bulk_density", .value = density, .unit = "kg/m3", .unit_as_read = e->unit_as_read, .standard_error = error, .assumed = e->assumed, .seeds = e->seeds,
          .definition = "from void_ratio and the grain density", .sigma3 = 0};
  }

  void compare(const Scalar& rho, const Scalar& e, const Known& grain) {
    const double meant = grain.value / rho.value - 1;
    const double error = std::hypot(e.standard_error, (1 + meant) * std::hypot(rho.standard_error / rho.value, grain.standard_error.value_or(0) / grain.value));
    if (std::abs(meant - e.value) <= kContradict * error) return;
    warnings_.add(at_.at("void_ratio").second, "void_ratio " + shown(e.value, "1") + " and bulk_density " + shown(rho.value, "kg/m3") + " contradict each other (with grains of " +
                                                   shown(grain.value, "kg/m3") + " that density means a void ratio of " + shown(meant, "1") +
                                                   ") check the grain density; the density is kept");
  }

  const MissingErrors missing_;
  ObservationSet& set_;
  Report& report_;
  Report& warnings_;
  std::map<std::string, std::pair<std::size_t, Place>> at_, curve_at_;  ///< by id: index, where it stood first
};

}  // namespace

void check_observations(const RawObservations& raw, MissingErrors missing, ObservationSet& set, Report& report, Report& warnings) {
  Checker checker(missing, set, report, warnings);
  for (const RawScalar& scalar : raw.scalars) checker.scalar(scalar);
  for (const RawCurve& curve : raw.curves) checker.curve(curve);
  checker.finish();
}

}  // namespace regolab::gap
