#include "worker/dem/margins.h"

#include <algorithm>
#include <cmath>

namespace regolab::dem {

void allow(const Bodies& b, const Travel& travel, std::vector<double>& distance) {
  const std::size_t n = b.x.size();
  distance.resize(n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double v2 = b.vx[i] * b.vx[i] + b.vy[i] * b.vy[i] + b.vz[i] * b.vz[i];
    const double w2 = b.wx[i] * b.wx[i] + b.wy[i] * b.wy[i] + b.wz[i] * b.wz[i];
    distance[i] = std::sqrt(fastest_point2(v2, w2, b.swing[i]));
    sum += distance[i];
  }
  const double mean = n > 0 ? sum / static_cast<double>(n) : 0.0;  // a cluster at rest may be hit by one that is not
  for (double& d : distance) d = std::clamp(travel.time * (d + mean), travel.least, travel.most);
}

void Lasting::renew(std::int64_t step, double held, double search) {
  const double cost = held + search / static_cast<double>(std::max<std::int64_t>(1, step - made_at));
  if (cost > cost_before) factor = 1 / factor;
  steps = std::clamp(factor * steps, low, high);
  cost_before = cost;
  made_at = step;
}

}  // namespace regolab::dem
