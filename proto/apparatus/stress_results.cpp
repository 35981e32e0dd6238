#include "apparatus/stress_results.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace regolab {
namespace {

std::string kilopascal(double pascal) {  // 1250 -> "1.25kPa", as in the observation ids
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, std::round(pascal) / 1000);
  return std::string(buffer, end.ptr) + "kPa";
}

struct Mean {
  double value = 0, standard_error = 0;
};

/// Mean over strain in (from, to]; the standard error takes samples one correlation length (about 1 % strain) apart as independent.
template <class Value>
Mean mean_between(const std::vector<StressSample>& samples, double from, double to, Value value) {
  double sum = 0, squares = 0;
  int n = 0;
  constexpr double kHalfInterval = 0.00125;  // a sample is the mean over the interval that ends at its strain
  for (const StressSample& s : samples) {
    if (s.strain < from + kHalfInterval || s.strain > to + kHalfInterval) continue;
    sum += value(s);
    squares += value(s) * value(s);
    ++n;
  }
  if (n == 0) return {};
  const double mean = sum / n, variance = std::max(0.0, squares / n - mean * mean);
  const double independent = std::max(1.0, (to - from) / 0.01);
  return {mean, std::sqrt(variance / independent)};
}

/// Secant modulus at half the peak deviator stress [Pa]; 0 when the curve starts above it.
double secant_modulus(const std::vector<StressSample>& samples) {
  double peak = 0;
  for (const StressSample& s : samples) peak = std::max(peak, s.sigma1() - s.sigma3());
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double q0 = samples[i - 1].sigma1() - samples[i - 1].sigma3(), q1 = samples[i].sigma1() - samples[i].sigma3();
    if (q0 < 0.5 * peak && q1 >= 0.5 * peak) {
      const double share = (0.5 * peak - q0) / (q1 - q0);
      const double strain = samples[i - 1].strain + share * (samples[i].strain - samples[i - 1].strain);
      return strain > 0 ? 0.5 * peak / strain : 0;
    }
  }
  return 0;
}

}  // namespace

std::string stress_id(double sigma3) { return "_at_sigma3_" + kilopascal(sigma3); }

void add_stress_results(const std::vector<StressSample>& samples, double sigma3, double end_strain, double void_ratio0,
                        StageResult& out) {
  const std::string at = stress_id(sigma3);
  const double last = end_strain - std::min(0.05, 0.25 * end_strain);  // the last quarter, at most 0.05
  const auto sigma1 = [](const StressSample& s) { return s.sigma1(); };
  const Mean critical = mean_between(samples, last, end_strain, sigma1);
  const Mean lateral = mean_between(samples, last, end_strain, [](const StressSample& s) { return s.sigma3(); });
  const auto peak = std::max_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.sigma1() < b.sigma1(); });
  out.measurements = {
      {"sigma1" + at, critical.value, "Pa", critical.standard_error, "mean axial stress over the last quarter of the axial strain, at most its last 0.05"},
      {"sigma1_peak" + at, peak->sigma1(), "Pa", {}, "largest axial stress of the curve"},
      {"sigma3_measured" + at, lateral.value, "Pa", lateral.standard_error, "mean lateral stress over the same strains"},
      {"void_ratio_compressed_" + kilopascal(sigma3), void_ratio0, "1", {}, "between the plates, after the isotropic stage"},
  };
  if (end_strain >= 0.2) {
    const Mean middle = mean_between(samples, 0.10, 0.20, sigma1);
    out.measurements.push_back(
        {"sigma1_0.10_0.20" + at, middle.value, "Pa", middle.standard_error, "mean axial stress over axial strains 0.10 to 0.20"});
  }
  if (const double modulus = secant_modulus(samples); modulus > 0) {
    out.measurements.push_back({"E50" + at, modulus, "Pa", {}, "secant modulus at half the peak deviator stress"});
  }
  const auto curve = [&](const std::string& id, const char* name, const char* unit, auto value) {
    Curve c{id, "stress", "axial_strain", "1", name, unit, {}, {}};
    for (const StressSample& s : samples) {
      c.x.push_back(s.strain);
      c.y.push_back(value(s));
    }
    out.curves.push_back(std::move(c));
  };
  curve("sigma1" + at, "sigma1", "Pa", sigma1);
  curve("sigma3" + at, "sigma3", "Pa", [](const StressSample& s) { return s.sigma3(); });
  curve("volumetric_strain_contraction_positive" + at, "volumetric_strain", "1", [](const StressSample& s) { return s.volumetric_strain; });
  curve("top_plate_stress" + at, "top_plate_stress", "Pa", [](const StressSample& s) { return s.top; });
  curve("bottom_plate_stress" + at, "bottom_plate_stress", "Pa", [](const StressSample& s) { return s.bottom; });
}

}  // namespace regolab
