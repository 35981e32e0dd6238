#include "worker/bench/timing.h"

#include <time.h>

#include "worker/bench/bed.h"
#include "worker/dem/contacts.h"

namespace regolab::bench {
namespace {

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

StepCost time_steps(int warm_up, int steps, dem::World& world) {
  advance(warm_up, world);
  const double wall = seconds_of(CLOCK_MONOTONIC), cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
  advance(steps, world);
  const double to_us = 1e6 / steps;
  return {.wall_us = to_us * (seconds_of(CLOCK_MONOTONIC) - wall),
          .cpu_us = to_us * (seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu)};
}

TouchCount touches(const dem::World& world) {
  return {.grains = static_cast<long>(dem::contacts(world).size()), .walls = static_cast<long>(dem::wall_contacts(world).size())};
}

}  // namespace regolab::bench
