/// The name of the profile whose numerics these are.
#pragma once
#include <string>

#include "vocab/profile.h"

namespace regolab {

/// Size and box apart; empty when a study chose its own.
inline std::string profile_name(const Numerics& n) {
  for (const std::string_view name : kProfileNames) {
    Numerics p = *profile(name);
    p.clusters = n.clusters, p.box_length = n.box_length, p.box_width = n.box_width;
    if (p == n) return std::string(name);
  }
  return "";
}

}  // namespace regolab
