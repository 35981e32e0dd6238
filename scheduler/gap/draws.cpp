#include "scheduler/gap/draws.h"

#include "scheduler/random/philox.h"

namespace regolab::gap {

Eigen::VectorXd normals(Eigen::Index n, std::uint64_t seed, int stream) {
  const Philox random(seed, 0x100000000ULL + static_cast<std::uint64_t>(stream));
  return Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index k) { return random.normal(static_cast<std::uint64_t>(k)); });
}

double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, std::uint64_t number) { return Philox(seed, stream).uniform(index, number); }

}  // namespace regolab::gap
