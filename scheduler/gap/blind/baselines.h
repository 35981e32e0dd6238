/// What people do without a diagnosis, on the same features and the same emulator: refit and take the lowest misfit, BIC, nearest pattern.
#pragma once
#include <string>
#include <vector>

#include "scheduler/gap/hypothesis.h"

namespace regolab::gap {

/// One model refitted: the base model, or one effect.
struct Refit {
  std::string model;
  double rms = 0;             ///< of (measured - predicted)/standard error; errors are those of measurement and seeds
  double log_likelihood = 0;  ///< largest, with full covariance
  int parameters = 0;
  double bic_probability = 0;  ///< exp(-BIC/2), normalised over the models: equal priors
  double cosine = 0;           ///< of what the base model leaves with this effect's mean shift; 0 of the base model
};

struct Baselines {
  std::vector<Refit> refits;    ///< the base model first
  std::string lowest_rms;       ///< the model refitted best; it is never the base model where that is nested
  std::string bic;              ///< most probable by BIC
  std::string nearest_pattern;  ///< largest cosine; "none" where the base model's misfit is within chance (95 %)
  double base_misfit_p = 1;     ///< of chi-square, the base model refitted
};

Baselines baselines_of(const Emulator& emulator, const ObservationSet& set, std::uint64_t seed);

}  // namespace regolab::gap
