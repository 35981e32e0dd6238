/// LAMMPS as a program beside us: the same bed under the same law, and the states it passes through.
#pragma once
#include <filesystem>
#include <vector>

#include "support/grain_bed.h"

namespace regolab::test {

/// One run. All walls have the grains' springs and dashpots; the floor has their friction, the sides their own.
struct Setting {
  dem::LinearLaw law;
  double side_friction = 0;   ///< tan
  double gravity = 0;         ///< [m/s2]
  double dt = 0;              ///< [s]
  long steps = 0, every = 0;  ///< a state is kept every so many steps, the first and the last among them
};

struct State {
  double time = 0;         ///< [s]
  GrainBed bed;            ///< velocities at this time
  double floor_force = 0;  ///< mean over the steps since the state before, positive downwards [N]
};

/// True where the program `lmp` can be found.
bool lammps_is_installed();

/// The states of LAMMPS, files in `directory`. What went wrong is the error.
Result<std::vector<State>> run_lammps(const GrainBed& start, const Setting& setting, const std::filesystem::path& directory);

/// The same by us.
std::vector<State> run_ours(const GrainBed& start, const Setting& setting);

}  // namespace regolab::test
