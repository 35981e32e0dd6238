#include "scheduler/gap/blind/records.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "apparatus/stress_results.h"
#include "scheduler/gap/blind/parts.h"

namespace regolab::gap {
namespace {

constexpr double kEndStrain = 0.2;  // of the bank's stress tests

const Curve* curve_of(const StageResult& result, const std::string& id) {
  const auto found = std::ranges::find(result.curves, id, &Curve::id);
  return found == result.curves.end() ? nullptr : &*found;
}

std::vector<StressSample> samples_of(const StageResult& result, double sigma3) {
  const std::string at = stress_id(sigma3);
  const Curve *top = curve_of(result, "top_plate_stress" + at), *bottom = curve_of(result, "bottom_plate_stress" + at),
              *lateral = curve_of(result, "sigma3" + at), *volume = curve_of(result, "volumetric_strain_contraction_positive" + at);
  std::vector<StressSample> out;
  if (!top || !bottom || !lateral || !volume) return out;
  for (std::size_t i = 0; i < top->x.size(); ++i) {
    out.push_back({.strain = top->x[i],
                   .top = top->y[i],
                   .bottom = bottom->y[i],
                   .lateral_x = lateral->y[i],
                   .lateral_y = lateral->y[i],
                   .volumetric_strain = volume->y[i]});
  }
  return out;
}

double void_ratio_of(const StageResult& result) {
  const auto found = std::ranges::find_if(result.measurements, [](const Measurement& m) { return m.id.starts_with("void_ratio_compressed_"); });
  return found == result.measurements.end() ? 0 : found->value;
}

/// The same test with other samples: every number is made anew from them.
StageResult with_samples(const StageResult& result, const std::vector<StressSample>& samples, double sigma3) {
  StageResult out = result;
  out.measurements.clear(), out.curves.clear();
  if (!samples.empty()) add_stress_results(samples, sigma3, kEndStrain, void_ratio_of(result), out);
  return out;
}

template <class Change>
void change_samples(SpecimenRecord& record, const Change& change) {
  for (auto& [sigma3, result] : record.stress) {
    auto samples = samples_of(result, sigma3);
    for (StressSample& sample : samples) change(sample);
    result = with_samples(result, samples, sigma3);
  }
}

void change_axial(SpecimenRecord& record, double (*change)(double stress, double strain, double p), double p) {
  change_samples(record, [&](StressSample& s) {
    s.top = change(s.top, s.strain, p);
    s.bottom = change(s.bottom, s.strain, p);
  });
}

/// Axial readings of both tests interchanged; what the lateral and volume gauges said stays.
void swap_axial(SpecimenRecord& record, std::size_t first) {
  const double a = kBlindStresses[first], b = kBlindStresses[first + 1];
  const auto at_a = record.stress.find(a), at_b = record.stress.find(b);
  if (at_a == record.stress.end() || at_b == record.stress.end()) return;
  auto in_a = samples_of(at_a->second, a), in_b = samples_of(at_b->second, b);
  const std::size_t n = std::min(in_a.size(), in_b.size());
  in_a.resize(n), in_b.resize(n);
  for (std::size_t i = 0; i < n; ++i) std::swap(in_a[i].top, in_b[i].top), std::swap(in_a[i].bottom, in_b[i].bottom);
  at_a->second = with_samples(at_a->second, in_a, a);
  at_b->second = with_samples(at_b->second, in_b, b);
}

void misread_height(StageResult& fabric, double share) {
  for (Measurement& m : fabric.measurements) {
    if (m.id == "bulk_density" || m.id == "bulk_density_Hmax") m.value /= 1 + share;
    if (m.id == "void_ratio") m.value = (1 + m.value) * (1 + share) - 1;
  }
}

}  // namespace

StageResult relabelled(const StageResult& result, double applied, double said) {
  if (applied == said) return result;
  auto samples = samples_of(result, applied);
  for (StressSample& s : samples) s.lateral_x *= said / applied, s.lateral_y *= said / applied;
  return with_samples(result, samples, said);
}

void misrecord(const Truth& truth, SpecimenRecord& record) {
  const auto parameter = [&](const char* name) { return truth.parameters.at(name); };
  if (truth.unknown == "drifting_load_cell") {
    change_axial(
        record, [](double s, double strain, double drift) { return s + drift * strain / 0.2; }, parameter("drift_at_0.2_Pa"));
  } else if (truth.unknown == "saturating_load_cell") {
    change_axial(
        record, [](double s, double, double s0) { return s / std::hypot(1, s / s0); }, parameter("s_0_Pa"));
  } else if (truth.unknown == "bottom_cell_gain") {
    change_samples(record, [&](StressSample& s) { s.bottom *= 1 + parameter("gain"); });
  } else if (truth.unknown == "leaking_volume_gauge") {
    change_samples(record, [&](StressSample& s) { s.volumetric_strain -= parameter("leak_at_0.2") * s.strain / 0.2; });
  } else if (truth.unknown == "swapped_records") {
    swap_axial(record, static_cast<std::size_t>(parameter("first")));
  } else if (truth.unknown == "misread_height" && record.fabric) {
    misread_height(*record.fabric, parameter("share"));
  }
}

}  // namespace regolab::gap
