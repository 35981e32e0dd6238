#include "worker/generate/random.h"

#include <Random123/philox.h>

namespace regolab::generate {

double Random::uniform(Purpose purpose, std::uint64_t particle, std::uint64_t draw) const {
  const r123::Philox4x64::ctr_type counter = {{particle, draw, 0, 0}};
  const r123::Philox4x64::key_type key = {{seed_, static_cast<std::uint64_t>(purpose)}};
  return static_cast<double>(r123::Philox4x64{}(counter, key)[0] >> 11) * 0x1.0p-53;
}

}  // namespace regolab::generate
