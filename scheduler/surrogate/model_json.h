/// A surrogate as a file: data and hyperparameters. Digits are round-trip exact, so a loaded model gives the same bits.
#pragma once
#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

/// From what the file says, its own id apart.
std::string id_of(const Model& model);

}  // namespace regolab::surrogate
