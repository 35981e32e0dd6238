/// Beds whose steps are worth timing: the article's grains under lunar gravity, settled the fast way. SI.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "worker/dem/world.h"

namespace regolab::bench {

/// Grains of 0.2 to 1 cm (parents, uniform by number) over a square base.
struct BedPlan {
  int clusters = 1000;
  int spheres_each = 6;  ///< 1 (the parents themselves), 2, 4 or 6
  double width = 0.042;  ///< [m]
  std::uint64_t seed = 1;
};

inline constexpr double kSteadyStep = 1e-6;  ///< [s] a third of what the smallest six-sphere cluster bears
inline constexpr double kFastStep = 2e-6;    ///< [s] for settling

/// The law of all timings (K 7.5e4 N/m, eta 0.25 N s/m, 40 degrees), gravity, four walls and a floor with the same friction.
void furnish(double length, double width, dem::World& world);

/// The generated clusters at rest, before they fall. Empty when the parents find no room.
std::optional<dem::World> cloud(const BedPlan& plan);

/// Called now and then with the share of the work done.
using OnProgress = std::function<void(double fraction)>;

void advance(int steps, dem::World& world, const OnProgress& on_progress = {});

/// From the cloud to near rest: a drop under 50 m/s2, rest under lunar gravity with drag, a last stretch without drag at
/// kSteadyStep.
void settle(dem::World& world, const OnProgress& on_progress = {});

}  // namespace regolab::bench
