#include "apparatus/apparatus.h"

#include <algorithm>

namespace regolab {
namespace {

const Curve* find_curve(const StageResult& result, const std::string& id) {
  const auto found = std::ranges::find(result.curves, id, &Curve::id);
  return found == result.curves.end() ? nullptr : &*found;
}

const Measurement* find_measurement(const StageResult& result, std::string_view start) {
  const auto found = std::ranges::find_if(result.measurements, [&](const Measurement& m) { return m.id.starts_with(start); });
  return found == result.measurements.end() ? nullptr : &*found;
}

/// The samples that the curves were made of; empty when curves are missing or differ in length.
std::vector<StressSample> samples_of(const StageResult& result, const std::string& at) {
  const Curve* top = find_curve(result, "top_plate_stress" + at);
  const Curve* bottom = find_curve(result, "bottom_plate_stress" + at);
  const Curve* lateral = find_curve(result, "sigma3" + at);
  const Curve* volume = find_curve(result, "volumetric_strain_contraction_positive" + at);
  std::vector<StressSample> samples;
  for (const Curve* curve : {top, bottom, lateral, volume}) {
    if (curve == nullptr || curve->y.size() != top->x.size()) return samples;
  }
  for (std::size_t i = 0; i < top->x.size(); ++i) {
    samples.push_back({.strain = top->x[i], .top = top->y[i], .bottom = bottom->y[i], .lateral_x = lateral->y[i],
                       .lateral_y = lateral->y[i], .volumetric_strain = volume->y[i]});
  }
  return samples;
}

}  // namespace

Apparatus apparatus_of(const EffectSet& effects) {
  return {.frame_compliance = effects[EffectId::kFrameCompliance],
          .seating = effects[EffectId::kSeating],
          .load_cell_offset = effects[EffectId::kLoadCellOffset],
          .load_cell_gain = effects[EffectId::kLoadCellGain]};
}

std::vector<StressSample> as_measured(const std::vector<StressSample>& samples, const Apparatus& apparatus) {
  if (apparatus.ideal() || samples.empty()) return samples;
  std::vector<StressSample> measured;
  const double start = samples.front().sigma1();
  for (StressSample sample : samples) {
    sample.strain += apparatus.frame_compliance * (sample.sigma1() - start) + apparatus.seating;
    for (double* stress : {&sample.top, &sample.bottom}) *stress = (1 + apparatus.load_cell_gain) * *stress + apparatus.load_cell_offset;
    measured.push_back(sample);
  }
  if (apparatus.seating > 0) {
    measured.insert(measured.begin(), measured.front());
    measured.front().strain = 0;
  }
  return measured;
}

Result<StageResult> as_measured(const StageResult& ideal, double sigma3, double end_strain, const Apparatus& apparatus) {
  const std::vector<StressSample> samples = samples_of(ideal, stress_id(sigma3));
  const Measurement* void_ratio = find_measurement(ideal, "void_ratio_compressed_");
  if (samples.empty() || void_ratio == nullptr) {
    return invalid("no stress curves (the stage has not completed, or is another test) take a completed stress stage");
  }
  StageResult out = ideal;
  out.measurements.clear();
  out.curves.clear();
  add_stress_results(as_measured(samples, apparatus), sigma3, end_strain, void_ratio->value, out);
  return out;
}

}  // namespace regolab
