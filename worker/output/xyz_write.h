/// A bed as extended XYZ, read by OVITO and ASE.
#pragma once
#include <string>

#include "worker/stage/run_stage.h"

namespace regolab {

/// One line per sphere: species, position [m], radius [m], cluster (0-based), velocity [m/s], number of contacts.
/// The lattice is the box; readers insist on a chemical symbol for the species, so it is `Si` throughout.
std::string bed_xyz(const BedView& bed);

}  // namespace regolab
