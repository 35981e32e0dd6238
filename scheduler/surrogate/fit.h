/// From a dataset to the observations behind each process, and from left-out materials to skill.
#pragma once
#include "scheduler/surrogate/model.h"

namespace regolab::surrogate {

inline constexpr const char* kStrengthFamily = "sigma1_at_sigma3_*";

/// Responses that are modelled together: one property, or one at several confining stresses.
struct Family {
  std::string name;                 ///< "bulk_density", "sigma1_at_sigma3_*"
  std::vector<std::string> members; ///< [m] ids, by stress
  Eigen::MatrixXd contrast;         ///< [m][m] orthonormal: member j = sum over k of contrast(j, k) * process k
  std::vector<std::size_t> rows;    ///< of the dataset, that hold every member
  Scatter scatter;                  ///< of one run, as modelled
};

/// What the data hold often enough to be learned, in the order of names.
std::vector<Family> families_of(const Dataset& data);

/// How the runs of one material scatter, from the seeds behind each row.
Scatter scatter_of(const Dataset& data, const Family& family);

/// What process k of a family is fitted to.
Observations observations_of(const Dataset& data, const Family& family, std::size_t k);

/// The members conditioned on the data with these hyperparameters [m]; not judged yet.
std::vector<ResponseModel> response_models(const Dataset& data, const Family& family, const std::vector<Hyperparameters>& hyperparameters);
/// Inflation and skill, from leaving out each material.
void judge(const Dataset& data, const Family& family, std::vector<ResponseModel>& members);

/// Whether a response is modelled at all, and whether by its logarithm (stresses, moduli, forces: they scale, and are positive).
bool is_modelled(const std::string& response);
bool by_logarithm(const std::string& response);

}  // namespace regolab::surrogate
