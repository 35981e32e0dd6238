/// The figures in words: this machine, and how long a study would take on it.
#pragma once
#include <string>

#include "worker/bench/measure.h"

namespace regolab::bench {

struct Study {
  std::string profile = "quick";
  int rows = 32;  ///< materials
  int seeds = 1;
  int workers = 1;  ///< worker processes, one core each
};

/// REQUIRES: a known profile.
std::string report(const MachineFigure& figure, const Study& study);

}  // namespace regolab::bench
