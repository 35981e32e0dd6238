/// A bed as plain numbers, from which any code can start: where the spheres are and how the clusters move. No springs.
#pragma once
#include <string>
#include <vector>

#include "vocab/result.h"
#include "worker/dem/world.h"

namespace regolab::test {

using dem::Vec3;

struct Grain {
  std::vector<Vec3> centre;    ///< of its spheres [m]
  std::vector<double> radius;  ///< [m]
  Vec3 velocity{};             ///< of its centre of mass [m/s]
  Vec3 spin{};                 ///< [1/s]
};

struct GrainBed {
  double length = 0, width = 0;  ///< of the box, which stands on z = 0 and has no lid [m]
  std::vector<Grain> grains;
};

/// Of a world whose walls stand at 0 and at length and width. Velocities as the world has them: half a step behind.
GrainBed grains_of(const dem::World& world);

/// Adds the grains, with their velocities, to a world; law, walls and step are the caller's.
void add_grains(const GrainBed& bed, double density, dem::World& world);

/// Copies side by side, every second one mirrored in the shared wall: who leaned on the wall leans on its own image.
GrainBed tiled(const GrainBed& bed, int along_x, int along_y);

/// The highest point of any grain [m].
double top_of(const GrainBed& bed);

/// CSV: the box, then a row per sphere with the motion of its cluster. Every digit is kept.
std::string to_csv(const GrainBed& bed);
Result<GrainBed> from_csv(const std::string& text);

/// LAMMPS's data file for atom_style sphere: clusters as molecules, each sphere with the velocity of its own centre. The
/// simulation box ends `headroom` above the bed.
std::string to_lammps_data(const GrainBed& bed, double density, double headroom);

}  // namespace regolab::test
