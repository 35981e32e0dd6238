#include "worker/dem/margins.h"

#include <algorithm>
#include <cmath>

namespace regolab::dem {

void Margins::renew(const Bodies& b, double dt, double least, double most) {
  const std::size_t n = b.x.size();
  margin.resize(n);
  path.assign(n, 0.0);
  anything_swings = std::any_of(b.swing.begin(), b.swing.end(), [](double swing) { return swing > 0; });
  for (std::size_t i = 0; i < n; ++i) {
    const double v2 = b.vx[i] * b.vx[i] + b.vy[i] * b.vy[i] + b.vz[i] * b.vz[i];
    const double w2 = b.wx[i] * b.wx[i] + b.wy[i] * b.wy[i] + b.wz[i] * b.wz[i];
    margin[i] = std::clamp(kSteps * dt * std::sqrt(fastest_point2(v2, w2, b.swing[i])), least, most);
  }
}

}  // namespace regolab::dem
