/// A made-up study whose truth is known: density and sigma1 as smooth functions of friction, size and shape.
#pragma once
#include <cmath>

#include "scheduler/surrogate/dataset.h"
#include "vocab/units.h"

namespace regolab::surrogate::testing_support {

inline double true_density(double degrees, double centimetres, int shape) {
  return 1700 - 200 * std::tanh(degrees / 25) - 60 * shape + 10 * centimetres;
}
inline double true_sigma1(double sigma3, double degrees) { return sigma3 * (1.5 + 0.03 * degrees); }

/// 7 frictions x 4 sizes x 2 shapes; `noise` is a fixed pattern of that size [kg/m3].
inline ResultTable study(int seeds = 2, double noise = 2) {
  ResultTable table{.experiment = "made-up", .array = "table", .factors = {}, .fixed = {{"gravity", "1.63 m/s2"}, {"profile", "quick"}}, .responses = {}, .rows = {}};
  table.factors = {{"theta_F", "deg", {"1", "10", "20", "30", "40", "50", "60"}}, {"L_S", "cm", {"0.5", "1", "1.5", "2"}}, {"N_E", "1", {"2", "6"}}};
  table.responses = {{"bulk_density", "kg/m3"}, {"sigma1_at_sigma3_5kPa", "Pa"}, {"sigma1_at_sigma3_10kPa", "Pa"}};
  int point = 0;
  for (int t = 0; t < 7; ++t) {
    for (int l = 0; l < 4; ++l) {
      for (int n = 0; n < 2; ++n) {
        ++point;
        for (int seed = 1; seed <= seeds; ++seed) {
          const double degrees = std::stod(table.factors[0].levels[static_cast<std::size_t>(t)]), size = std::stod(table.factors[1].levels[static_cast<std::size_t>(l)]);
          TableRow row{.point = point, .seed = static_cast<std::uint64_t>(seed), .level = {t, l, n}, .value = {}, .missing = {}};
          const double wobble = noise * std::sin(12.9898 * point + 78.233 * seed);
          row.value["bulk_density"] = true_density(degrees, size, n) + wobble;
          row.value["sigma1_at_sigma3_5kPa"] = true_sigma1(5e3, degrees) * (1 + 1e-3 * wobble);
          row.value["sigma1_at_sigma3_10kPa"] = true_sigma1(1e4, degrees) * (1 + 1e-3 * wobble);
          table.rows.push_back(std::move(row));
        }
      }
    }
  }
  return table;
}

}  // namespace regolab::surrogate::testing_support
