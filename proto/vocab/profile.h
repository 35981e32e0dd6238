/// The three accuracy profiles [protocols, section 3].
#pragma once
#include <optional>
#include <string_view>

#include "vocab/stage.h"

namespace regolab {

inline std::optional<Numerics> profile(std::string_view name) {
  if (name == "quick") return Numerics{};
  if (name == "standard") return Numerics{.clusters = 400, .stress_stiffness_number = 0, .inertial_number = 5e-3};
  if (name == "article") {
    return Numerics{.clusters = 1000, .settle_stiffness_number = 0, .stress_stiffness_number = 0, .mass_floor = 0,
                    .inertial_number = 1e-3, .axial_strain = 0.30};
  }
  return std::nullopt;
}

inline constexpr std::string_view kProfileNames[] = {"quick", "standard", "article"};

}  // namespace regolab
