/// The free surface of a bed, read on a grid of columns.
#pragma once
#include <vector>

#include "worker/protocol/bed.h"

namespace regolab::protocol {

/// Highest sphere surface over each of nx x ny column centres of the base; the floor (0) where none stands. [nx * ny], x fastest.
std::vector<double> surface_heights(const Bed& bed, int nx, int ny);

/// H of the density: mean over 24 x 24 columns [protocols, section 5] [m].
double mean_height(const Bed& bed);

/// Highest point of any present sphere [m].
double highest_point(const Bed& bed);

/// Solid fraction inside 0.15-0.85 L, 0.15-0.85 W, 0.2-0.75 H, from points on a regular grid.
double core_solid_fraction(const Bed& bed, double height);

}  // namespace regolab::protocol
