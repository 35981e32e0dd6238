/// What a process's answers cost most: covariances between its runs and a block of points, and products with them. Loops over the points
/// of a block, each with sums of its own in a fixed order: every processor gives the same bits, however wide its registers.
#pragma once
#include <Eigen/Dense>

namespace regolab::gap {

inline constexpr Eigen::Index kBlock = 64;  ///< points: what they need stays in the cache
inline constexpr Eigen::Index kTile = 4;    ///< columns that are multiplied together

/// [rows][points of a block], and factors of a product. Row by row.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// With columns of zeros up to a multiple of kTile.
Rows padded(const Eigen::MatrixXd& m);

/// c = a^T b. a: [k][m], m a multiple of kTile; b: [k][kBlock]; c: [m][kBlock].
void multiply(const Rows& a, const Rows& b, Rows& c);

/// c += Matern 5/2 covariances. run: [n][d], point: [d][kBlock], both divided by lengths; c: [n][kBlock].
void add_matern(const Rows& run, const Rows& point, Rows& c);

}  // namespace regolab::gap
