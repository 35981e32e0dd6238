#include "scheduler/gap/features.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "input/number_text.h"
#include "scheduler/gap/curve_mean.h"
#include "scheduler/gap/quantities.h"

namespace regolab::gap {
namespace {

/// A value under way to a feature.
struct Value {
  double value = 0, standard_error = 0;
  int repeats = 1;
  bool assumed = false;
};
using Maybe = std::optional<Value>;

Maybe scaled(Maybe v, double factor) {
  if (v) v->value *= factor, v->standard_error *= std::abs(factor);
  return v;
}

Maybe logarithm(const Maybe& v) {
  if (!v || !(v->value > 0)) return std::nullopt;
  return Value{std::log(v->value), v->standard_error / v->value, v->repeats, v->assumed};
}

/// Steps of strain over which the noise of a curve is forgotten; packings of a few hundred grains rearrange about so often.
constexpr double kForgets = 0.02;

class Reader {
 public:
  explicit Reader(const Readings& readings) : readings_(readings) {}

  Maybe plain(const std::string& id) const {
    if (id == "surface_roughness") return roughness();
    if (id == "repose_wedge") return wedge();
    if (id == "repose_angle_whole" && stood()) return std::nullopt;  // a line along the top of a bed that stood is no slope
    if (id == "strength_cohesion") return scalar("cohesion");
    if (id == "strength_friction_angle") return scalar("friction_angle_internal");
    return scalar(id);
  }

  Maybe stress(const std::string& stem, double sigma3) const {
    const std::string at = "_at_sigma3_" + kilopascals(sigma3) + "kPa";
    const auto share = [&](const Maybe& v) { return scaled(v, 1 / sigma3); };
    if (stem == "void_ratio_compressed") return scalar("void_ratio_compressed_" + kilopascals(sigma3) + "kPa");
    if (stem == "sigma1_early") return logarithm(share(curve("sigma1" + at, 0.005, 0.015)));
    if (stem == "sigma1_rising") return logarithm(share(curve("sigma1" + at, 0.02, 0.04)));
    if (stem == "sigma1_middle") return logarithm(share(curve("sigma1" + at, 0.05, 0.10)));
    if (stem == "sigma1_peak_ratio") return logarithm(share(scalar("sigma1_peak" + at)));
    if (stem == "sigma1_ratio") return logarithm(share(residual("sigma1" + at, "sigma1" + at)));
    if (stem == "E50_ratio") return logarithm(share(scalar("E50" + at)));
    if (stem == "volumetric_strain_0.05") return curve("volumetric_strain_contraction_positive" + at, 0.04, 0.06);
    if (stem == "volumetric_strain_0.10") return curve("volumetric_strain_contraction_positive" + at, 0.09, 0.11);
    if (stem == "volumetric_strain_0.19") return curve("volumetric_strain_contraction_positive" + at, 0.18, 0.20);
    if (stem == "sigma3_measured_ratio") return share(residual("sigma3_measured" + at, "sigma3" + at));
    if (stem == "plate_difference") return plate_difference(at);
    return std::nullopt;
  }

  /// Mean force about a depth given in plate widths, over a tenth of a width to either side.
  Maybe penetration(double widths, const std::string& plate) const {
    const auto width = leading_number(plate);
    if (!width || !(width->value > 0)) return std::nullopt;
    const double w = width->value / 1000;
    return logarithm(curve("penetration_force_plate_" + plate, (widths - 0.1) * w, (widths + 0.1) * w));
  }

 private:
  Maybe scalar(const std::string& id) const {
    const auto found = readings_.scalars.find(id);
    if (found == readings_.scalars.end()) return std::nullopt;
    const Reading& r = found->second;
    return Value{r.value, r.standard_error, r.repeats, r.assumed};
  }

  Maybe curve(const std::string& id, double low, double high) const {
    const auto found = readings_.curves.find(id);
    if (found == readings_.curves.end()) return std::nullopt;
    const auto mean = mean_over(found->second, low, high);
    if (!mean) return std::nullopt;
    return Value{mean->value, mean->standard_error, found->second.repeats, found->second.assumed};
  }

  /// Over axial strains of 0.15 to 0.20: the number, else the curve. A test that went further has its number from further on.
  Maybe residual(const std::string& scalar_id, const std::string& curve_id) const {
    const auto found = readings_.curves.find(curve_id);
    const bool went_on = found != readings_.curves.end() && !found->second.x.empty() && found->second.x.back() > 0.21;
    const Maybe number = went_on ? std::nullopt : scalar(scalar_id);
    return number ? number : curve(curve_id, 0.15, 0.20);
  }

  /// ln of mean over highest bed: grain density, masses and base cancel, so the errors are those of two heights, taken as independent.
  Maybe roughness() const {
    const Maybe mean = logarithm(scalar("bulk_density")), top = logarithm(scalar("bulk_density_Hmax"));
    if (!mean || !top) return std::nullopt;
    return Value{mean->value - top->value, std::hypot(mean->standard_error, top->standard_error), std::min(mean->repeats, top->repeats), mean->assumed || top->assumed};
  }

  bool stood() const {
    const Maybe share = scalar("repose_column_stood");
    return share && share->value > 0;
  }

  /// atan(2 mean(h)/L), from the profile [protocols Sec. 6]; a profile is less noisy than a line through it.
  Maybe wedge() const {
    const auto found = readings_.curves.find("repose_profile");
    if (found == readings_.curves.end()) return scalar("repose_angle_wedge");
    const auto mean = mean_height(found->second);
    if (!mean) return std::nullopt;
    const double ratio = 2 * mean->height.value / mean->length;
    return Value{std::atan(ratio), 2 * mean->height.standard_error / mean->length / (1 + ratio * ratio), found->second.repeats, found->second.assumed};
  }

  /// (top - bottom)/(top + bottom) over 0.05 to 0.20. DEVIATION: both plates carry the same sigma1, whose scatter cancels in the ratio;
  /// their errors taken as independent would be ten times what the ratio shows. So its own scatter along the curve is its error,
  /// forgotten every kForgets of strain, beside what unequal errors of the plates leave.
  Maybe plate_difference(const std::string& at) const {
    const auto top = readings_.curves.find("top_plate_stress" + at), bottom = readings_.curves.find("bottom_plate_stress" + at);
    if (top == readings_.curves.end() || bottom == readings_.curves.end() || top->second.x != bottom->second.x) return std::nullopt;
    constexpr double kLow = 0.05, kHigh = 0.20;
    const auto t = mean_over(top->second, kLow, kHigh), b = mean_over(bottom->second, kLow, kHigh);
    if (!t || !b || !(t->value + b->value > 0)) return std::nullopt;
    const double sum = t->value + b->value, ratio = (t->value - b->value) / sum;
    Value out{ratio, 0, std::min(top->second.repeats, bottom->second.repeats), top->second.assumed || bottom->second.assumed};
    if (top->second.y_standard_error.empty()) return out;
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < top->second.x.size(); ++i) {
      const double both = top->second.y[i] + bottom->second.y[i];
      if (top->second.x[i] < kLow || top->second.x[i] > kHigh || !(both > 0)) continue;
      const double apart = (top->second.y[i] - bottom->second.y[i]) / both - ratio;
      squares += apart * apart, ++n;
    }
    const double along = n > 1 ? std::sqrt(squares / (n - 1) / std::min(n, (kHigh - kLow) / kForgets)) : 0;
    const double uneven = 2 * std::abs(b->value * t->standard_error - t->value * b->standard_error) / (sum * sum);
    out.standard_error = std::hypot(along, uneven);
    return out;
  }

  const Readings& readings_;
};

Maybe value_of(const Reader& reader, const FeatureInfo& info) {
  const auto cut = info.id.rfind('_');
  switch (info.group.test) {
    case Test::kStress: return info.group.sigma3 > 0 ? reader.stress(info.id.substr(0, cut), info.group.sigma3) : reader.plain(info.id);
    case Test::kPenetration: {
      const auto depth = leading_number(std::string_view(info.id).substr(std::string_view("penetration_").size()));
      return depth ? reader.penetration(depth->value, info.id.substr(cut + 1)) : std::nullopt;
    }
    default: return reader.plain(info.id);
  }
}

}  // namespace

std::vector<double> sigma3_of(const Readings& readings) {
  std::set<double> all;  // ids are in normal form: equal stresses are equal numbers
  for (const auto& [id, reading] : readings.scalars) {
    if (const auto known = scalar_id(id); known && known->sigma3 > 0) all.insert(known->sigma3);
  }
  for (const auto& [id, reading] : readings.curves) {
    if (const auto known = curve_id(id); known && known->sigma3 > 0) all.insert(known->sigma3);
  }
  return {all.begin(), all.end()};
}

std::vector<std::string> plates_of(const Readings& readings) {
  constexpr std::string_view kStem = "penetration_force_plate_";
  std::vector<std::string> plates;
  for (const auto& [id, curve] : readings.curves) {
    if (id.starts_with(kStem)) plates.push_back(id.substr(kStem.size()));
  }
  return plates;
}

std::vector<Feature> features_of(const Readings& readings) {
  const Reader reader(readings);
  std::vector<Feature> out;
  const auto sigma3 = sigma3_of(readings);
  const auto plates = plates_of(readings);
  for (const FeatureInfo& info : all_features(sigma3, plates)) {
    const Maybe v = value_of(reader, info);
    if (!v || !std::isfinite(v->value) || !std::isfinite(v->standard_error)) continue;
    out.push_back({info.id, info.group, v->value, v->standard_error, v->repeats, v->assumed});
  }
  return out;
}

}  // namespace regolab::gap
