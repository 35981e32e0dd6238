/// Inverse design: materials that should measure what is wanted, and what the targets leave open.
#pragma once
#include "scheduler/surrogate/target_file.h"

namespace regolab::surrogate {

struct Candidate {
  std::vector<double> x;            ///< [n_columns]
  std::vector<Estimate> estimates;  ///< [n_targets]
  double probability = 0;           ///< that its mean over many runs meets every target, by the model
  double miss = 0;                  ///< largest |prediction - target| / tolerance
};

struct Inversion {
  std::vector<Candidate> candidates;  ///< best first, each of another combination of choices as long as there are any
  int tried = 0, fitting = 0;         ///< materials spread over the box; of them, those that may meet every target
  std::vector<Question::Span> freedom;///< [n_columns] what the fitting ones span; as asked where none fits
  std::vector<std::string> notes;     ///< targets out of reach, and what the box gives instead
};

/// The optimiser (BOBYQA) runs over the numbers from several starts, for every combination of the choices. Deterministic.
Inversion invert(const Model& model, const Question& question, std::size_t wanted);

}  // namespace regolab::surrogate
