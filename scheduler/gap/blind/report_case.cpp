#include "scheduler/gap/blind/report_case.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "scheduler/gap/blind/parts.h"
#include "scheduler/gap/quantities.h"
#include "vocab/units.h"

namespace regolab::gap {
namespace {

constexpr double kStrainStep = 0.0025;
constexpr int kStrainPoints = 81;         // 0 to 0.2
constexpr double kInertialNumber = 1e-2;  // of profile quick
constexpr double kGrainDensity = 2930;

/// To so many significant digits in the unit it will be written in.
double in_few_digits(double si, const std::string& unit, int digits) {
  const double factor = door_unit(unit).factor;
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, si * factor);
  return std::strtod(text, nullptr) / factor;
}
constexpr int kDigits = 4, kErrorDigits = 3;

struct MeanOfSpecimens {
  double value = 0, standard_error = 0;
};
MeanOfSpecimens mean_of(const std::vector<double>& v, const std::string& unit) {
  const auto n = static_cast<double>(v.size());
  double sum = 0, squares = 0;
  for (const double x : v) sum += x / n;
  for (const double x : v) squares += (x - sum) * (x - sum);
  return {in_few_digits(sum, unit, kDigits), v.size() < 2 ? 0 : in_few_digits(std::sqrt(squares / (n - 1) / n), unit, kErrorDigits)};
}

std::vector<const StageResult*> stages_of(const SpecimenRecord& record) {
  std::vector<const StageResult*> out;
  if (record.fabric) out.push_back(&*record.fabric);
  if (record.repose) out.push_back(&*record.repose);
  for (const auto& [sigma3, result] : record.stress) out.push_back(&result);
  return out;
}

/// Straight lines between the points in the order they were taken; where a reading runs back (a frame gives), its first passing counts.
std::vector<double> at_strains(const Curve& curve) {
  std::vector<double> out;
  std::size_t i = 0;
  for (int k = 0; k < kStrainPoints; ++k) {
    const double x = k * kStrainStep;
    while (i < curve.x.size() && curve.x[i] < x) ++i;
    const bool nearly_there = i == curve.x.size() && !curve.x.empty() && k + 1 == kStrainPoints && curve.x.back() > x - 0.5 * kStrainStep;
    if (i == curve.x.size() && !nearly_there) break;
    if (nearly_there || i == 0 || curve.x[i] == curve.x[i - 1]) {
      out.push_back(curve.y[std::min(i, curve.y.size() - 1)]);
      continue;
    }
    const double share = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
    out.push_back(curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]));
  }
  return out;
}

struct Gathered {
  std::vector<double> values;
  const Measurement* first = nullptr;
};

void add_scalars(const std::vector<SpecimenRecord>& specimens, ObservationSet& out) {
  std::map<std::string, Gathered> all;
  std::vector<std::string> order;
  for (const SpecimenRecord& specimen : specimens) {
    for (const StageResult* stage : stages_of(specimen)) {
      for (const Measurement& m : stage->measurements) {
        const auto id = scalar_id(m.id);
        if (!id || !std::isfinite(m.value)) continue;
        Gathered& of = all[id->normal];
        if (!of.first) of.first = &m, order.push_back(id->normal);
        of.values.push_back(m.value);
      }
    }
  }
  for (const std::string& id : order) {
    const Gathered& g = all.at(id);
    const MeanOfSpecimens mean = mean_of(g.values, g.first->unit);
    out.scalars.push_back({.id = id,
                           .value = mean.value,
                           .unit = g.first->unit,
                           .unit_as_read = g.first->unit,
                           .standard_error = mean.standard_error,
                           .assumed = g.values.size() < 2,
                           .seeds = static_cast<int>(g.values.size()),
                           .definition = g.first->definition,
                           .sigma3 = scalar_id(id)->sigma3});
  }
}

struct GatheredCurve {
  std::vector<std::vector<double>> y;  // [n_specimens][n_points]
  std::vector<double> x;
  const Curve* first = nullptr;
};

MeasuredCurve measured(const std::string& id, const GatheredCurve& g) {
  const auto known = curve_id(id);
  MeasuredCurve out{.id = id,
                    .test = g.first->test,
                    .sigma3 = known->sigma3,
                    .x_name = g.first->x_name,
                    .x_unit = g.first->x_unit,
                    .y_name = g.first->y_name,
                    .y_unit = g.first->y_unit,
                    .x_unit_as_read = g.first->x_unit,
                    .y_unit_as_read = g.first->y_unit,
                    .x = g.x,
                    .y = {},
                    .y_standard_error = {},
                    .assumed = g.y.size() < 2,
                    .seeds = static_cast<int>(g.y.size())};
  std::size_t shortest = g.x.size();
  for (const auto& y : g.y) shortest = std::min(shortest, y.size());
  out.x.resize(shortest);
  for (double& x : out.x) x = in_few_digits(x, out.x_unit, kDigits);
  for (std::size_t i = 0; i < shortest; ++i) {
    std::vector<double> at;
    for (const auto& y : g.y) at.push_back(y[i]);
    const MeanOfSpecimens mean = mean_of(at, out.y_unit);
    out.y.push_back(mean.value), out.y_standard_error.push_back(mean.standard_error);
  }
  return out;
}

void add_curves(const std::vector<SpecimenRecord>& specimens, ObservationSet& out) {
  std::map<std::string, GatheredCurve> all;
  std::vector<std::string> order;
  for (const SpecimenRecord& specimen : specimens) {
    for (const StageResult* stage : stages_of(specimen)) {
      for (const Curve& c : stage->curves) {
        const auto id = curve_id(c.id);
        if (!id || c.x.size() < 2) continue;
        GatheredCurve& of = all[id->normal];
        if (!of.first) of.first = &c, order.push_back(id->normal);
        of.y.push_back(c.x_name == "axial_strain" ? at_strains(c) : c.y);
        if (c.x_name != "axial_strain") of.x = c.x;
      }
    }
  }
  for (const std::string& id : order) {
    GatheredCurve& g = all.at(id);
    if (g.x.empty()) {
      for (int k = 0; k < kStrainPoints; ++k) g.x.push_back(k * kStrainStep);
    }
    if (MeasuredCurve curve = measured(id, g); curve.x.size() > 1) out.curves.push_back(std::move(curve));
  }
}

/// What the experimenter meant to do: the same words in every case.
void add_conditions(const Truth& truth, ObservationSet& out) {
  const double largest = truth.material.largest_cm / 100, size = std::cbrt(truth.particles / 400.0);
  out.name = (truth.development ? "development-" : "blind-") + truth.id;
  out.source = kSameCode;
  out.material.nominal_max_size = largest;
  out.material.nominal_min_size = in_few_digits(largest / 5, "m", kDigits);
  out.material.size_law = "uniform in diameter of the circumscribed sphere";
  out.material.grain_density = Known{.value = kGrainDensity, .standard_error = {}, .unit = "kg/m3"};
  out.specimen.particles = truth.particles;
  out.specimen.box_length = in_few_digits(3 * size * largest, "m", kDigits);
  out.specimen.box_width = in_few_digits(2.4 * size * largest, "m", kDigits);
  out.specimen.repeats = static_cast<int>(truth.seeds.size());
  out.protocol.gravity = truth.material.gravity;
  out.protocol.preparation = "random generation, replacement, sedimentation in a box with plane walls";
  out.protocol.repose = "right wall removed, lowest layer fixed, material falls off the edge";
  out.protocol.stress =
      "no gravity, six plane walls, lateral walls servo-controlled, top plate moves down at a ramped constant rate, bottom plate fixed";
  for (const double sigma3 : kBlindStresses) {
    out.protocol.sigma3.push_back(sigma3);
    out.protocol.stated_strain_rate.push_back(in_few_digits(kInertialNumber / (0.6 * largest) * std::sqrt(sigma3 / kGrainDensity), "1/s", kDigits));
  }
}

}  // namespace

ObservationSet observation_of(const Truth& truth, const std::vector<SpecimenRecord>& specimens) {
  ObservationSet out;
  add_conditions(truth, out);
  add_scalars(specimens, out);
  add_curves(specimens, out);
  return out;
}

}  // namespace regolab::gap
