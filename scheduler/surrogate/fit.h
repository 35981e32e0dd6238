/// From a dataset to the observations of one response, and from left-out points to skill.
#pragma once
#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

/// Whether a response is modelled at all, and whether by its logarithm (stresses, moduli, forces: they scale, and are positive).
bool is_modelled(const std::string& response);
bool by_logarithm(const std::string& response);

/// The rows that hold the response, in order; `rows` says which.
Observations observations_of(const Dataset& data, const std::string& response, std::vector<std::size_t>& rows);

/// The response conditioned on the data with these hyperparameters; inflation and skill from leaving out each point.
ResponseModel response_model(const Dataset& data, const std::string& response, const Hyperparameters& hyperparameters);

}  // namespace regolab::surrogate
