#include "worker/bench/measure.h"

#include <algorithm>
#include <vector>

namespace regolab::bench {
namespace {

constexpr int kWarmUp = 200;
constexpr double kSettlingShare = 0.8;  // of all the time, for the progress

}  // namespace

std::optional<MachineFigure> measure_machine(const MachinePlan& plan, const OnProgress& on_progress) {
  auto settled = cloud(plan.bed);
  if (!settled) return std::nullopt;
  const auto tell = [&](double fraction) {
    if (on_progress) on_progress(fraction);
  };
  settle(*settled, [&](double fraction) { tell(kSettlingShare * fraction); });
  MachineFigure figure{.clusters = settled->bodies.count(),
                       .spheres = settled->bodies.first_sphere.back(),
                       .rounds = plan.rounds,
                       .steps_a_round = plan.steps_a_round};
  std::vector<double> us;
  for (int round = 0; round < plan.rounds; ++round) {
    dem::World world = *settled;
    us.push_back(time_steps(kWarmUp, plan.steps_a_round, world).cpu_us);
    figure.touching = touches(world);
    tell(kSettlingShare + (1 - kSettlingShare) * (round + 1) / plan.rounds);
  }
  std::sort(us.begin(), us.end());
  figure.least_us = us.front();
  figure.most_us = us.back();
  figure.us_per_step = 0.5 * (us[(us.size() - 1) / 2] + us[us.size() / 2]);
  return figure;
}

}  // namespace regolab::bench
