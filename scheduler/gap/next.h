/// Which test would tell most about which cause it is.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scheduler/gap/hypothesis.h"

namespace regolab::gap {

struct NextTest {
  std::string test;
  std::optional<double> nats;        ///< expected fall of the entropy over causes; none: no emulator foretells this test
  double nats_error = 0;             ///< Monte Carlo standard error
  double hours = 0;                  ///< of a laboratory, assumed
  std::vector<std::string> splits;   ///< "cohesion | loading_rate": pairs of causes that it tells apart, likeliest first
};

/// What a hypothesis foretells rests on: its probability, and draws from its posterior.
struct Believed {
  Hypothesis hypothesis;
  std::string cause;                 ///< the class that counts
  double probability = 0;
  Eigen::MatrixXd u;                 ///< [n_parameters][n_draws]
};

struct NextQuestion {
  const Emulator& emulator;
  const Comparison& comparison;      ///< what is measured
  const std::map<std::string, Stated>& stated;
  const std::vector<Believed>& believed;
  int specimens = 3;                 ///< of a new test
  double size_ratio = 1;             ///< see `compare`
  std::uint64_t seed = 1;
};

/// Tests with emulators by information per hour, then those without that would tell likely causes apart. Each draw of each hypothesis
/// foretells a new measurement given those at hand: what the emulator or the code gets wrong in them, it gets wrong there alike.
std::vector<NextTest> next_tests(const NextQuestion& question);

/// Entropy of the causes' probabilities: the most that any test can tell [nat].
double entropy_of_causes(const std::vector<Believed>& believed);

}  // namespace regolab::gap
