#include "scheduler/gap/draws.h"

#include <Random123/boxmuller.hpp>
#include <Random123/philox.h>
#include <Random123/uniform.hpp>

namespace regolab::gap {
namespace {

r123::Philox4x64::ctr_type words(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, std::uint64_t number) {
  return r123::Philox4x64{}({{index, number, 0, 0}}, {{seed, stream}});
}

}  // namespace

Eigen::VectorXd normals(Eigen::Index n, std::uint64_t seed, int stream) {
  Eigen::VectorXd out(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto w = words(seed, 0x100000000ULL + static_cast<std::uint64_t>(stream), static_cast<std::uint64_t>(k), 0);
    out[k] = r123::boxmuller(w[0], w[1]).x;
  }
  return out;
}

double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, std::uint64_t number) {
  return r123::u01fixedpt<double>(words(seed, stream, index, number)[0]);
}

}  // namespace regolab::gap
