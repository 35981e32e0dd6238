/// Counter-based random numbers of the diagnosis: functions of (seed, stream, index) alone.
#pragma once
#include <Eigen/Dense>
#include <cstdint>

namespace regolab::gap {

/// Standard normal numbers. [n]
Eigen::VectorXd normals(Eigen::Index n, std::uint64_t seed, int stream);
/// Uniform in (0, 1).
double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, std::uint64_t number = 0);

}  // namespace regolab::gap
