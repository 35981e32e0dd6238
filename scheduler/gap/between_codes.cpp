#include "scheduler/gap/between_codes.h"

#include <cmath>
#include <string_view>

namespace regolab::gap {
namespace {

/// A feature's share in a difference: the same at every sigma3, and rising with its logarithm (from -slope at 1.25 to slope at 10 kPa).
struct Share {
  std::string_view stem;  ///< id without sigma3
  double level = 0, slope = 0;
};
using Difference = std::vector<Share>;

// Sizes were read off the five development files of another code against our emulators at their true parameters: its beds are 1 % less
// dense, its pressed specimens 2 % looser and less so under more pressure, and what follows from that. Other codes will differ otherwise,
// so each size is a standard deviation, not a correction; they are the same in every hypothesis.
const std::vector<Difference>& differences() {
  static const std::vector<Difference> all = {
      {{"bulk_density", -1.2}, {"core_density", -1.0}, {"void_ratio_compressed", 1.6, -0.6}, {"volumetric_strain_0.05", 0.8}, {"volumetric_strain_0.10", 0.8},
       {"volumetric_strain_0.19", 1.0}, {"sigma1_middle", -0.4}, {"sigma1_peak_ratio", -0.6}},
      {{"contacts_per_particle", 0.4}, {"neighbours_per_particle", 0.4}},
      {{"bulk_density", 0.6}, {"core_density", 0.6}},
      {{"repose_angle", 0.4}, {"repose_angle_whole", 0.4}, {"repose_wedge", 0.3}},
      {{"void_ratio_compressed", 0.8}},
      {{"void_ratio_compressed", 0, 0.6}},
      {{"void_ratio_compressed", 0, -0.8}, {"volumetric_strain_0.05", 0.4, 0.4}, {"volumetric_strain_0.10", 0.3, 0.3}},
      {{"volumetric_strain_0.05", 0.5}, {"volumetric_strain_0.10", 0.5}, {"volumetric_strain_0.19", 0.5}},
      {{"volumetric_strain_0.05", 0, 0.4}, {"volumetric_strain_0.10", 0, 0.4}, {"volumetric_strain_0.19", 0, 0.4}},
      {{"sigma1_early", 0.5}, {"sigma1_rising", 0.5}, {"E50_ratio", 0.5}},
      {{"sigma1_early", 0, 0.4}, {"sigma1_rising", 0, 0.3}, {"E50_ratio", 0, 0.3}},
      {{"sigma1_middle", 0.9}, {"sigma1_peak_ratio", 0.9}, {"sigma1_ratio", 0.9}},
      {{"sigma1_middle", 0, 0.3}, {"sigma1_peak_ratio", 0, 0.3}, {"sigma1_ratio", 0, 0.3}},
  };
  return all;
}

double share_of(const Difference& difference, const Feature& feature) {
  const double sigma3 = feature.group.sigma3;
  const std::string_view stem = sigma3 > 0 ? std::string_view(feature.id).substr(0, feature.id.rfind('_')) : std::string_view(feature.id);
  for (const Share& share : difference) {
    if (share.stem != stem) continue;
    return share.level + (sigma3 > 0 ? share.slope * std::log(sigma3 / std::sqrt(1250.0 * 10000.0)) / (0.5 * std::log(8.0)) : 0);
  }
  return 0;
}

Eigen::VectorXd shares_of(const Difference& difference, const std::vector<Feature>& features) {
  Eigen::VectorXd out(std::ssize(features));
  for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = share_of(difference, features[static_cast<std::size_t>(k)]);
  return out;
}

}  // namespace

Eigen::VectorXd by_step(const std::vector<Feature>& features) {
  static const Difference step = {{"sigma3_measured_ratio", 0.3, -0.12}, {"sigma1_peak_ratio", 0.3, -0.15}, {"volumetric_strain_0.05", 0.18}, {"surface_roughness", 0.3},
                                  {"repose_wedge", -0.2}, {"repose_angle_whole", -0.2}, {"bulk_density", -0.2}, {"E50_ratio", -0.2}};
  return shares_of(step, features);
}

Eigen::VectorXd by_records(const std::vector<Feature>& features) {
  static const Difference records = {{"sigma1_peak_ratio", 0.32}, {"sigma3_measured_ratio", 0.22}};
  return shares_of(records, features);
}

Eigen::MatrixXd between_codes(const std::vector<Feature>& features) {
  const auto& all = differences();
  Eigen::MatrixXd out(std::ssize(features), std::ssize(all));
  for (Eigen::Index r = 0; r < out.cols(); ++r) out.col(r) = shares_of(all[static_cast<std::size_t>(r)], features);
  return out;
}

}  // namespace regolab::gap
