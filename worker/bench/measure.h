/// How fast this machine is at our work, as one figure.
#pragma once
#include <optional>

#include "worker/bench/bed.h"
#include "worker/bench/timing.h"

namespace regolab::bench {

struct MachineFigure {
  int clusters = 0, spheres = 0;
  TouchCount touching;
  int rounds = 0, steps_a_round = 0;
  double us_per_step = 0, least_us = 0, most_us = 0;  ///< median, least and most of the rounds; processor time of one core

  double sphere_steps_per_s() const { return spheres / us_per_step * 1e6; }
  /// What a step costs per cluster. Of all our measures it varies least between kinds of clusters: contacts go with
  /// clusters.
  double us_per_cluster_step() const { return us_per_step / clusters; }
};

struct MachinePlan {
  BedPlan bed = {.clusters = 300, .spheres_each = 6, .width = 0.023};
  int rounds = 9, steps_a_round = 5000;
};

/// Settles the bed, then times the same steps from the same state in each round. Empty when the parents find no room.
std::optional<MachineFigure> measure_machine(const MachinePlan& plan, const OnProgress& on_progress = {});

}  // namespace regolab::bench
